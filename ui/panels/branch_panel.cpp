#include "ui/panels/branch_panel.h"

#include "ui/panels/branch_delegate.h"
#include "ui/panels/branch_model.h"

#include <QEvent>
#include <QItemSelectionModel>
#include <QListView>
#include <QMenu>
#include <QScopedValueRollback>

namespace ui {

BranchPanel::BranchPanel(QWidget* parent)
    : Section(tr("Branches"), Folding::Fixed, parent),
      model_(new BranchModel(this)),
      list_(new QListView),
      empty_(roleLabel("hint", tr("No vessels yet. Open a centreline: VTP, VTK, CSV or SWC.")))
{
    auto* delegate = new BranchDelegate(this);
    list_->setModel(model_);
    list_->setItemDelegate(delegate);
    list_->setSelectionMode(QAbstractItemView::ExtendedSelection);
    list_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    list_->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    list_->setFrameShape(QFrame::NoFrame);
    list_->setMouseTracking(true);
    list_->setContextMenuPolicy(Qt::CustomContextMenu);
    list_->setAccessibleName(tr("Branches"));
    list_->viewport()->installEventFilter(this);
    list_->setMinimumHeight(60);
    empty_->setWordWrap(true);
    empty_->setAlignment(Qt::AlignTop);
    layout()->setContentsMargins(0, 10, 0, 0);
    layout()->itemAt(0)->layout()->setContentsMargins(14, 0, 14, 0);
    empty_->setContentsMargins(14, 0, 14, 0);
    contentLayout()->addWidget(empty_, 1);
    contentLayout()->addWidget(list_, 1);

    connect(delegate, &BranchDelegate::auxiliaryClicked, this,
            [this](int id) { emit auxiliaryToggled(affectedBy(id)); });
    connect(delegate, &BranchDelegate::excludeClicked, this, [this](int id) { emit excludedToggled(affectedBy(id)); });
    connect(list_, &QListView::entered, this,
            [this](const QModelIndex& index) { emit hovered(model_->idAt(index.row())); });
    connect(list_->selectionModel(), &QItemSelectionModel::selectionChanged, this, &BranchPanel::reportSelection);
    connect(list_, &QWidget::customContextMenuRequested, this, &BranchPanel::showContextMenu);
    showTree({});
}

void BranchPanel::showTree(const core::VesselTree& tree)
{
    const QScopedValueRollback quiet(showing_, true);
    model_->setTree(tree);
    empty_->setVisible(tree.branches.empty());
    list_->setVisible(!tree.branches.empty());
    setHint(tree.branches.empty() ? QString() : tr("A auxiliary · X exclude"));
}

void BranchPanel::showMarks(const BranchMarks& marks)
{
    const QScopedValueRollback quiet(showing_, true);
    marks_ = marks;
    model_->setMarks(marks);
    if (selectedIds() == marks.selected) {
        return;
    }
    QItemSelection selection;
    for (const int id : marks.selected) {
        if (const int row = model_->rowOf(id); row >= 0) {
            selection.select(model_->index(row), model_->index(row));
        }
    }
    list_->selectionModel()->select(selection, QItemSelectionModel::ClearAndSelect);
    if (!selection.isEmpty()) {
        list_->scrollTo(selection.indexes().front());
    }
}

void BranchPanel::showResiduals(const std::map<int, double>& residualMm, double scaleMaximumMm)
{
    model_->setResiduals(residualMm, scaleMaximumMm);
}

bool BranchPanel::eventFilter(QObject* watched, QEvent* event)
{
    if (watched == list_->viewport() && event->type() == QEvent::Leave) {
        emit hovered(std::nullopt);
    }
    return Section::eventFilter(watched, event);
}

std::set<int> BranchPanel::selectedIds() const
{
    std::set<int> ids;
    for (const QModelIndex& index : list_->selectionModel()->selectedIndexes()) {
        ids.insert(model_->idAt(index.row()));
    }
    return ids;
}

std::set<int> BranchPanel::affectedBy(int branchId) const
{
    const std::set<int> selected = selectedIds();
    return selected.contains(branchId) ? selected : std::set{branchId};
}

void BranchPanel::showContextMenu(const QPoint& position)
{
    const QModelIndex index = list_->indexAt(position);
    if (!index.isValid()) {
        return;
    }
    const std::set<int> affected = affectedBy(model_->idAt(index.row()));
    auto* menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->addAction(tr("Auxiliary on or off\tA"), this, [this, affected] { emit auxiliaryToggled(affected); });
    menu->addAction(tr("Exclude or include\tX"), this, [this, affected] { emit excludedToggled(affected); });
    menu->addSeparator();
    menu->addAction(tr("Only these auxiliary"), this, [this, affected] { emit onlyTheseAuxiliary(affected); });
    menu->addAction(tr("No auxiliary branches (use the nodes)"), this, &BranchPanel::auxiliaryCleared);
    menu->popup(list_->viewport()->mapToGlobal(position));
}

void BranchPanel::reportSelection()
{
    if (!showing_) {
        emit selectionEdited(selectedIds());
    }
}

}   // namespace ui
