#include "ui/panels/measure_panel.h"

#include "ui/actions/key_hint.h"
#include "ui/theme/active_theme.h"
#include "ui/words/retranslation.h"

#include <QAction>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QScopedValueRollback>
#include <QTreeWidget>

#include <algorithm>
#include <utility>

namespace angiopose::ui {
namespace {

constexpr int maxVisibleMeasurements = 6;
enum MeasureColumn { MeasureName, MeasureValue, MeasureColumnCount };

Command commandOf(core::MeasurementKind kind)
{
    return kind == core::MeasurementKind::Length  ? Command::MeasureLength
           : kind == core::MeasurementKind::Angle ? Command::MeasureAngle
                                                  : Command::MeasureArea;
}

QString kindText(core::MeasurementKind kind)
{
    return kind == core::MeasurementKind::Length  ? MeasurePanel::tr("Length")
           : kind == core::MeasurementKind::Angle ? MeasurePanel::tr("Angle")
                                                  : MeasurePanel::tr("Area");
}

QPushButton* makeModeButton(core::MeasurementKind kind)
{
    auto* button = withText(new QPushButton, [kind] { return kindText(kind); });   // too narrow for shortcuts
    withToolTip(button, [kind] { return withShortcut(kindText(kind), commandOf(kind)); });
    button->setCheckable(true);
    return button;
}

}   // namespace

MeasurePanel::MeasurePanel(QWidget* parent)
    : Section(
          "measure", [] { return tr("Measure"); }, Folding::Foldable, parent),
      plane_(new QComboBox),
      scale_(new QDoubleSpinBox),
      list_(new QTreeWidget),
      basis_(roleLabel("hint")),
      modes_{makeModeButton(core::MeasurementKind::Length), makeModeButton(core::MeasurementKind::Angle),
             makeModeButton(core::MeasurementKind::Area)},
      remove_(withText(new QPushButton, [] { return tr("Remove"); })),
      export_(withText(new QPushButton, [] { return tr("Table…"); }))
{
    withAccessibleName(plane_, [] { return tr("Measurement basis"); });
    withToolTip(plane_,
                [] { return tr("Measures lengths at the depth of the vessels, at the detector, or in pixels."); });
    withAccessibleName(scale_, [] { return tr("Image scale"); });
    withToolTip(scale_, [] { return tr("Pixel size in the patient, if known from another source."); });
    scale_->setDecimals(4);
    scale_->setRange(0.0, 100.0);
    scale_->setSingleStep(0.01);
    scale_->setKeyboardTracking(false);
    withToolTip(remove_, [] { return tr("Removes the selected measurements (Delete)"); });
    withToolTip(export_, [] { return tr("Writes all measurements and their basis to a CSV file."); });
    remove_->setProperty("role", "quiet");
    basis_->setWordWrap(true);
    setUpList();
    auto* modes = new QHBoxLayout;
    modes->setSpacing(8);
    for (QPushButton* mode : modes_) {
        modes->addWidget(mode);
    }
    auto* buttons = new QHBoxLayout;
    buttons->setSpacing(8);
    buttons->addWidget(remove_);
    buttons->addWidget(export_);
    contentLayout()->addLayout(modes);
    contentLayout()->addWidget(plane_);
    contentLayout()->addWidget(scale_);
    contentLayout()->addWidget(list_);
    contentLayout()->addWidget(basis_);
    contentLayout()->addLayout(buttons);
    setFolded(true);
    connectParts();
    keepTranslated(this, [this] {
        const QSignalBlocker quiet(plane_);
        scale_->setSuffix(tr(" mm per pixel"));
        scale_->setSpecialValueText(tr("no scale entered"));
        setItemTexts(*plane_, {tr("at the vessels"), tr("at the detector"), tr("in pixels"), tr("by entered scale")});
    });
    showMeasurements({});
}

void MeasurePanel::setUpList()
{
    withAccessibleName(list_, [] { return tr("Measurements in image and slices"); });
    list_->setColumnCount(MeasureColumnCount);
    list_->setHeaderHidden(true);
    list_->setRootIsDecorated(false);
    list_->setFrameShape(QFrame::NoFrame);
    list_->setSelectionMode(QAbstractItemView::ExtendedSelection);
    list_->setEditTriggers(QAbstractItemView::EditKeyPressed | QAbstractItemView::DoubleClicked);
    list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    list_->header()->setStretchLastSection(false);
    list_->header()->setSectionResizeMode(MeasureName, QHeaderView::Stretch);
    list_->header()->setSectionResizeMode(MeasureValue, QHeaderView::ResizeToContents);
    list_->installEventFilter(this);
}

void MeasurePanel::connectParts()
{
    connect(plane_, &QComboBox::activated, this,
            [this](int index) { emit planePicked(static_cast<core::MeasurementPlane>(index)); });
    connect(scale_, &QDoubleSpinBox::valueChanged, this, &MeasurePanel::scaleTyped);
    connect(remove_, &QPushButton::clicked, this, &MeasurePanel::removeSelected);
    connect(export_, &QPushButton::clicked, this, &MeasurePanel::exportRequested);
    connect(list_, &QTreeWidget::itemSelectionChanged, this, [this] {
        if (!isUpdating_) {
            showBasis();
            emit selectionChanged();
        }
    });
    connect(list_, &QTreeWidget::itemChanged, this, [this](QTreeWidgetItem* item, int column) {
        if (!isUpdating_ && column == MeasureName) {
            emit renamed(list_->indexOfTopLevelItem(item), item->text(MeasureName));
        }
    });
}

void MeasurePanel::bindMode(core::MeasurementKind kind, QAction& action)
{
    QPushButton* mode = modes_[static_cast<std::size_t>(kind)];
    connect(mode, &QPushButton::clicked, &action, [&action](bool on) { action.setChecked(on); });
    connect(&action, &QAction::toggled, this, [this, mode](bool on) {
        mode->setChecked(on);
        if (on) {
            setFolded(false);
        }
    });
}

std::set<int> MeasurePanel::selectedRows() const
{
    std::set<int> rowIndices;
    for (QTreeWidgetItem* item : list_->selectedItems()) {
        rowIndices.insert(list_->indexOfTopLevelItem(item));
    }
    return rowIndices;
}

void MeasurePanel::showMeasurements(const MeasureState& state)
{
    const QScopedValueRollback quiet(isUpdating_, true);
    state_ = state;
    const auto count = static_cast<int>(state.rows.size());
    while (list_->topLevelItemCount() > count) {
        delete list_->takeTopLevelItem(list_->topLevelItemCount() - 1);
    }
    for (int place = 0; place < count; ++place) {
        QTreeWidgetItem* item = list_->topLevelItem(place);
        if (!item) {
            item = new QTreeWidgetItem(list_);
            item->setFlags(item->flags() | Qt::ItemIsEditable);
        }
        const MeasureRow& row = state.rows[static_cast<std::size_t>(place)];
        item->setText(MeasureName, row.name);
        item->setText(MeasureValue, row.value);
        item->setTextAlignment(MeasureValue, Qt::AlignRight | Qt::AlignVCenter);
        item->setForeground(MeasureValue, toQColor(row.isDoubtful ? activePalette().attention : activePalette().text));
        for (int column = 0; column < MeasureColumnCount; ++column) {
            item->setToolTip(column, row.basis);
        }
    }
    const int rows = std::min(count, maxVisibleMeasurements);
    list_->setVisible(rows > 0);
    list_->setFixedHeight(rows > 0 ? rows * list_->sizeHintForRow(0) + 4 : 0);
    plane_->setCurrentIndex(static_cast<int>(state.plane));
    const QSignalBlocker quietScale(scale_);
    scale_->setVisible(state.plane == core::MeasurementPlane::Typed);
    scale_->setValue(state.enteredMmPerPx.value_or(0.0));
    setHint(count == 0 ? QString() : tr("measured: %1").arg(count));
    showBasis();
}

/// Shows how the selected measurement was obtained; without a selection, explains the measurement plane.
void MeasurePanel::showBasis()
{
    const std::set<int> rowIndices = selectedRows();
    const bool isOne = rowIndices.size() == 1;
    const QString basis = isOne ? state_.rows[static_cast<std::size_t>(*rowIndices.begin())].basis : state_.basis;
    basis_->setText(basis);
    basis_->setVisible(!basis.isEmpty());
    remove_->setEnabled(!rowIndices.empty());
    export_->setEnabled(!state_.rows.empty());
}

void MeasurePanel::removeSelected()
{
    if (const std::set<int> rowIndices = selectedRows(); !rowIndices.empty()) {
        emit removeRequested(rowIndices);
    }
}

void MeasurePanel::changeEvent(QEvent* event)
{
    Section::changeEvent(event);
    if (event->type() == QEvent::PaletteChange) {
        showMeasurements(MeasureState(state_));
    }
}

bool MeasurePanel::eventFilter(QObject* watched, QEvent* event)
{
    const bool isKey = event->type() == QEvent::KeyPress || event->type() == QEvent::ShortcutOverride;
    if (watched != list_ || !isKey) {
        return Section::eventFilter(watched, event);
    }
    const int key = static_cast<QKeyEvent*>(event)->key();
    if (event->type() == QEvent::ShortcutOverride) {   // these keys apply to measurements here, not to branches
        event->setAccepted(key == Qt::Key_Delete || key == Qt::Key_F2);
        return event->isAccepted();
    }
    if (key == Qt::Key_Delete) {
        removeSelected();
    }
    return key == Qt::Key_Delete;
}

}   // namespace angiopose::ui
