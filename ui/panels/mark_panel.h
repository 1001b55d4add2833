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

/// Row of the mark list.
struct MarkRow {
    QString name;
    QString value;   ///< error, width or type of the mark
    QString basis;   ///< how the value was obtained, in full sentences
    bool isDoubtful = false;   ///< true if the error exceeds the pose uncertainty
};

/// Panel for target points, ostium rings, arrows and text annotations: buttons for the modes that create them, and a
/// list to select, rename and remove them.
class MarkPanel : public Section {
    Q_OBJECT
public:
    explicit MarkPanel(QWidget* parent = nullptr);

    void showMarks(const std::vector<MarkRow>& rows, const QString& note);   ///< emits no signal, keeps the selection
    void bindMode(std::size_t mode, QAction& action);   ///< connects the action of a mode; `mode` is a ui::MarkMode
    std::set<int> selectedRows() const;   ///< indices of the selected rows
    void choose(int index);

signals:
    void selectionChanged();   ///< emitted when the selection has changed; see `chosen`
    void renamed(int index, const QString& name);
    void removeRequested(const std::set<int>& rowIndices);
    void exportRequested();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void setUpList();
    void connectParts();
    void showBasis();
    void removeSelected();

    QTreeWidget* list_;
    QLabel* basis_;
    std::array<QPushButton*, 5> modes_;   ///< indexed by ui::MarkMode
    QPushButton* remove_;
    QPushButton* export_;
    std::vector<MarkRow> rows_;
    QString note_;
    bool isUpdating_ = false;   ///< true while the program, not the user, changes the list
};

}   // namespace angiopose::ui
