#pragma once

#include "ui/actions/command.h"
#include "ui/controls/section.h"

#include <QPushButton>

#include <array>
#include <set>
#include <vector>

class QAction;
class QTreeWidget;

namespace angiopose::ui {

/// A mark as it is listed.
struct MarkRow {
    QString name;
    QString value;   ///< its error, its width, or what it is
    QString basis;   ///< what the value rests on, sentences
    bool isDoubtful = false;   ///< more off than the pose claims
};

/// Check points, rings, arrows and texts: the modes that set them, and the list, in which they are chosen, renamed and
/// removed.
class MarkPanel : public Section {
    Q_OBJECT
public:
    explicit MarkPanel(QWidget* parent = nullptr);

    void showMarks(const std::vector<MarkRow>& rows, const QString& note);   ///< silent, keeps what is chosen
    void bindMode(std::size_t mode, QAction& action);   ///< by ui::MarkMode
    std::set<int> chosen() const;   ///< places in the list
    void choose(int place);

signals:
    void choiceChanged();   ///< `chosen`
    void renamed(int place, const QString& name);
    void removeRequested(const std::set<int>& places);
    void exportRequested();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void setUpList();
    void connectParts();
    void showBasis();
    void removeChosen();

    QTreeWidget* list_;
    QLabel* basis_;
    std::array<QPushButton*, 5> modes_;   ///< by ui::MarkMode
    QPushButton* remove_;
    QPushButton* export_;
    std::vector<MarkRow> rows_;
    QString note_;
    bool showing_ = false;   ///< true while the owner, not the user, changes the list
};

}   // namespace angiopose::ui
