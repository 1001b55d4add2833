#pragma once

#include <QImage>
#include <QWidget>

#include <vector>

class QCheckBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QScrollArea;
class QVBoxLayout;

namespace angiopose::ui {

struct RecentCase {
    enum class State { Present, Missing, InputsMissing };

    QString path;
    QImage picture;   ///< thumbnail; null if none was stored
    State state = State::Present;
    bool isPinned = false;
};

/// List of recent cases with thumbnails and pins; marks missing files and offers a search field for long lists.
class RecentList : public QWidget {
    Q_OBJECT
public:
    explicit RecentList(QWidget* parent = nullptr);

    void showCases(const std::vector<RecentCase>& cases, bool hasThumbnails);
    /// Returns the case name, with a note if files are missing.
    static QString labelOf(const QString& path, RecentCase::State state);

signals:
    void openRequested(const QString& path);
    void removeRequested(const QString& path);   ///< removes the case from the list but not from disk
    void pinToggled(const QString& path, bool pinned);
    void thumbnailsToggled(bool isEnabled);
    void clearRequested();

private:
    QWidget* makeRow(const RecentCase& recent);
    void clearRows();
    void showMatches();

    std::vector<RecentCase> cases_;
    QLineEdit* search_;
    QWidget* rows_;
    QVBoxLayout* rowLayout_;
    QScrollArea* area_;
    QLabel* emptyLabel_;
    QCheckBox* showThumbnails_;
    QPushButton* clear_;
};

}   // namespace angiopose::ui
