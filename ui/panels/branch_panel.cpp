#include "ui/panels/branch_panel.h"

#include "ui/actions/key_hint.h"
#include "ui/panels/branch_delegate.h"
#include "ui/panels/branch_model.h"
#include "ui/words/retranslation.h"

#include <QAction>
#include <QComboBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QItemSelectionModel>
#include <QLineEdit>
#include <QListView>
#include <QMenu>
#include <QPushButton>
#include <QScopedValueRollback>
#include <QSortFilterProxyModel>

#include <array>

namespace angiopose::ui {
namespace {

constexpr int maxGenerationFilter = 6;

struct Order {
    const char* label;
    int role;
    Qt::SortOrder direction;
};

/// Sort orders of the list; the longest, widest or worst-fitting branch comes first.
constexpr std::array orders{
    Order{QT_TRANSLATE_NOOP("angiopose::ui::BranchPanel", "in tree order"), BranchModel::OrderRole, Qt::AscendingOrder},
    Order{QT_TRANSLATE_NOOP("angiopose::ui::BranchPanel", "by name"), BranchModel::NameRole, Qt::AscendingOrder},
    Order{QT_TRANSLATE_NOOP("angiopose::ui::BranchPanel", "by length"), BranchModel::LengthRole, Qt::DescendingOrder},
    Order{QT_TRANSLATE_NOOP("angiopose::ui::BranchPanel", "by radius"), BranchModel::RadiusRole, Qt::DescendingOrder},
    Order{QT_TRANSLATE_NOOP("angiopose::ui::BranchPanel", "by generation"), BranchModel::GenerationRole,
          Qt::AscendingOrder},
    Order{QT_TRANSLATE_NOOP("angiopose::ui::BranchPanel", "by residual"), BranchModel::ResidualRole,
          Qt::DescendingOrder}};

int idAt(const QModelIndex& index)
{
    return index.data(BranchModel::IdRole).toInt();
}

}   // namespace

BranchPanel::BranchPanel(QWidget* parent)
    : Section(
          "branches", [] { return tr("Branches"); }, Folding::Fixed, parent),
      model_(new BranchModel(this)),
      proxy_(new QSortFilterProxyModel(this)),
      list_(new QListView),
      filter_(new QLineEdit),
      order_(new QComboBox),
      filterRow_(makeFilterRow()),
      adviceRow_(makeAdviceRow()),
      empty_(withText(roleLabel("hint"),
                      [] { return tr("No vessels yet. Open a CT scan, a vessel mask or a centerline."); }))
{
    auto* delegate = new BranchDelegate(this);
    proxy_->setSourceModel(model_);
    proxy_->setFilterRole(BranchModel::NameRole);
    proxy_->setFilterCaseSensitivity(Qt::CaseInsensitive);
    proxy_->setSortCaseSensitivity(Qt::CaseInsensitive);
    proxy_->setSortLocaleAware(true);
    sortBy(0);
    list_->setModel(proxy_);
    list_->setItemDelegate(delegate);
    list_->setSelectionMode(QAbstractItemView::ExtendedSelection);
    list_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    list_->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    list_->setFrameShape(QFrame::NoFrame);
    list_->setMouseTracking(true);
    list_->setContextMenuPolicy(Qt::CustomContextMenu);
    withAccessibleName(list_, [] { return tr("Branches"); });
    list_->viewport()->installEventFilter(this);
    list_->setMinimumHeight(60);
    empty_->setWordWrap(true);
    empty_->setAlignment(Qt::AlignTop);
    layout()->setContentsMargins(0, 10, 0, 0);
    layout()->itemAt(0)->layout()->setContentsMargins(14, 0, 14, 0);
    empty_->setContentsMargins(14, 0, 14, 0);
    contentLayout()->addWidget(empty_, 1);
    contentLayout()->addWidget(filterRow_);
    contentLayout()->addWidget(list_, 1);
    contentLayout()->addWidget(adviceRow_);

    connect(delegate, &BranchDelegate::auxiliaryClicked, this,
            [this](int id) { emit auxiliaryToggled(affectedBy(id)); });
    connect(delegate, &BranchDelegate::excludeClicked, this, [this](int id) { emit excludedToggled(affectedBy(id)); });
    connect(list_, &QListView::entered, this, [this](const QModelIndex& index) { emit hovered(idAt(index)); });
    // Queued, because the owner responds with a new tree, which would delete the editor while it is in use.
    connect(model_, &BranchModel::renamed, this, &BranchPanel::renamed, Qt::QueuedConnection);
    connect(list_->selectionModel(), &QItemSelectionModel::selectionChanged, this, &BranchPanel::reportSelection);
    connect(list_, &QWidget::customContextMenuRequested, this, &BranchPanel::showContextMenu);
    showTree({});
    keepTranslated(this, [this] { showKeys(); });
    showAdvice({}, false);
}

QWidget* BranchPanel::makeFilterRow()
{
    keepTranslated(filter_, [this] { filter_->setPlaceholderText(tr("Find a branch")); });
    withAccessibleName(filter_, [] { return tr("Find a branch"); });
    filter_->setClearButtonEnabled(true);
    order_->setSizeAdjustPolicy(QComboBox::AdjustToContents);   // fits the item text in every language
    withAccessibleName(order_, [] { return tr("Branch order"); });
    withToolTip(order_, [] { return tr("Branch order"); });
    keepTranslated(order_, [this] {
        QStringList words;
        for (const Order& order : orders) {
            words << tr(order.label);
        }
        setItemTexts(*order_, words);
    });
    connect(filter_, &QLineEdit::textChanged, this, [this](const QString& text) {
        const QScopedValueRollback quiet(isUpdating_, true);
        proxy_->setFilterFixedString(text);
        selectMarked();
    });
    connect(order_, &QComboBox::currentIndexChanged, this, &BranchPanel::sortBy);
    auto* row = new QWidget;
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(14, 0, 14, 0);
    layout->setSpacing(6);
    layout->addWidget(filter_, 1);
    layout->addWidget(order_);
    return row;
}

QWidget* BranchPanel::makeAdviceRow()
{
    advice_ = roleLabel("attention");
    advice_->setWordWrap(true);
    repair_ = withText(new QPushButton, [] { return tr("Join"); });
    repair_->setProperty("role", "link");
    withToolTip(repair_, [] { return tooltipWithShortcut(tr("Bridges the gap; can be undone."), Command::BridgeGap); });
    auto* show = withText(new QPushButton, [] { return tr("Show"); });
    show->setProperty("role", "link");
    withToolTip(show, [] { return tr("Selects both branches and moves the crosshair to the gap."); });
    connect(repair_, &QPushButton::clicked, this, &BranchPanel::repairRequested);
    connect(show, &QPushButton::clicked, this, &BranchPanel::adviceShown);
    connect(this, &BranchPanel::repairableChanged, show, &QWidget::setVisible);
    auto* row = new QWidget;
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(14, 4, 8, 6);
    layout->setSpacing(2);
    layout->addWidget(advice_, 1);
    layout->addWidget(show);
    layout->addWidget(repair_);
    return row;
}

void BranchPanel::sortBy(int choice)
{
    const Order& order = orders[static_cast<std::size_t>(choice)];
    proxy_->setSortRole(order.role);
    proxy_->sort(0, order.direction);
}

void BranchPanel::showAdvice(const QString& text, bool isRepairable)
{
    advice_->setText(text);
    repair_->setVisible(isRepairable);
    emit repairableChanged(isRepairable);
    adviceRow_->setVisible(!text.isEmpty());
}

void BranchPanel::setEditActions(const QList<QAction*>& actions)
{
    editActions_ = actions;
}

void BranchPanel::editName(int branchId)
{
    if (!indexOf(branchId).isValid()) {
        filter_->clear();
    }
    const QModelIndex index = indexOf(branchId);
    list_->scrollTo(index);
    list_->setFocus();
    list_->edit(index);
}

void BranchPanel::focusFilter()
{
    filter_->setFocus(Qt::ShortcutFocusReason);
    filter_->selectAll();
}

QModelIndex BranchPanel::indexOf(int branchId) const
{
    const int row = model_->rowOf(branchId);
    return row < 0 ? QModelIndex() : proxy_->mapFromSource(model_->index(row));
}

void BranchPanel::showTree(const core::VesselTree& tree)
{
    const QScopedValueRollback quiet(isUpdating_, true);
    model_->setTree(tree);
    empty_->setVisible(tree.branches.empty());
    list_->setVisible(!tree.branches.empty());
    filterRow_->setVisible(!tree.branches.empty());
    selectMarked();
    showKeys();
}

void BranchPanel::showKeys()
{
    setHint(model_->rowCount() == 0
                ? QString()
                : tr("%1 auxiliary · %2 exclude").arg(keyOf(Command::ToggleAuxiliary), keyOf(Command::ToggleExcluded)));
}

void BranchPanel::showMarks(const BranchMarks& marks)
{
    const QScopedValueRollback quiet(isUpdating_, true);
    marks_ = marks;
    model_->setMarks(marks);
    if (selectedIds() != marks.selected) {
        selectMarked();
    }
}

void BranchPanel::selectMarked()
{
    QItemSelection selection;
    for (const int id : marks_.selected) {
        if (const QModelIndex index = indexOf(id); index.isValid()) {
            selection.select(index, index);
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
        ids.insert(idAt(index));
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
    const std::set<int> affected = affectedBy(idAt(index));
    auto* menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->addAction(tr("Toggle auxiliary") + QLatin1Char('\t') + keyOf(Command::ToggleAuxiliary), this,
                    [this, affected] { emit auxiliaryToggled(affected); });
    menu->addAction(tr("Exclude or include") + QLatin1Char('\t') + keyOf(Command::ToggleExcluded), this,
                    [this, affected] { emit excludedToggled(affected); });
    menu->addSeparator();
    menu->addAction(tr("Use only these as auxiliary"), this, [this, affected] { emit auxiliaryReplaced(affected); });
    menu->addAction(tr("Clear auxiliary branches"), this, &BranchPanel::auxiliaryCleared);
    menu->addSeparator();
    menu->addActions(editActions_);
    QMenu* generations = menu->addMenu(tr("Generation"));
    for (int generation = 0; generation <= maxGenerationFilter; ++generation) {
        generations->addAction(QString::number(generation), this,
                               [this, affected, generation] { emit generationChosen(affected, generation); });
    }
    generations->addAction(tr("unknown"), this, [this, affected] { emit generationChosen(affected, -1); });
    menu->popup(list_->viewport()->mapToGlobal(position));
}

void BranchPanel::reportSelection()
{
    if (!isUpdating_) {
        emit selectionEdited(selectedIds());
    }
}

}   // namespace angiopose::ui
