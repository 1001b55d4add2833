#pragma once

#include <QImage>
#include <QWidget>

#include <vector>

class QPushButton;
class QVBoxLayout;

namespace angiopose::ui {

struct RecentCase {
    QString path;
    QImage picture;   ///< null: none was made
};

/// What the middle shows while no case is open: what can be dropped, the sample case, recent cases.
class WelcomePage : public QWidget {
    Q_OBJECT
public:
    explicit WelcomePage(QWidget* parent = nullptr);

    void showRecent(const std::vector<RecentCase>& cases);

signals:
    void openRequested();
    void sampleRequested();
    void recentRequested(const QString& path);
    void clearRequested();   ///< of the list of recent cases

private:
    QPushButton* makeRecent(const RecentCase& recent);

    QVBoxLayout* recent_;
};

}   // namespace angiopose::ui