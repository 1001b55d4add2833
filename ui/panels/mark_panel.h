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

/// One row of the mark list.
struct MarkRow {
    QString name;
    QString value;   ///< error, width or type of the mark
    QString basis;   ///< basis of the value, in sentences
    bool isDoubtful = false;   ///< error larger than the pose uncertainty
};

/// Target points, rings, arrows and texts: the modes that set them, and the list in which they are selected, renamed
/// and removed.
class MarkPanel : public Section {
    Q_OBJECT
public:
    explicit MarkPanel(QWidget* parent = nullptr);

    void showMarks(const std::vector<MarkRow>& rows, const QString& note);   ///< emits no signal, keeps the selection
    void bindMode(std::size_t mode, QAction& action);   ///< indexed by ui::MarkMode
    std::set<int> chosen() const;   ///< row indices
    void choose(int place);

signals:
    void choiceChanged();   ///< see `chosen`
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
    std::array<QPushButton*, 5> modes_;   ///< indexed by ui::MarkMode
    QPushButton* remove_;
    QPushButton* export_;
    std::vector<MarkRow> rows_;
    QString note_;
    bool showing_ = false;   ///< true while the program, not the user, changes the list
};

}   // namespace angiopose::ui
