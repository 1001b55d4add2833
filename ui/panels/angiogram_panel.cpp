#include "ui/panels/angiogram_panel.h"

#include "ui/actions/key_hint.h"

#include <QCheckBox>
#include <QComboBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QPushButton>

#include <cmath>

namespace ui {
namespace {

QPushButton* quietButton(const QString& text, const QString& help)
{
    auto* button = new QPushButton(text);
    button->setProperty("role", "quiet");
    button->setToolTip(help);
    return button;
}

NumberFormat shiftFormat()
{
    return {-200.0, 200.0, 2, QStringLiteral("px"), 0.25, NumberSign::Always};
}

QString framesText(const std::vector<int>& frames)
{
    QStringList parts;
    for (std::size_t i = 0; i < frames.size(); ++i) {
        const std::size_t first = i;
        while (i + 1 < frames.size() && frames[i + 1] == frames[i] + 1) {
            ++i;
        }
        parts << (i > first ? QStringLiteral("%1–%2").arg(frames[first]).arg(frames[i])
                            : QString::number(frames[first]));
    }
    return parts.join(QStringLiteral(", "));
}

QString maskText(const RunState& state)
{
    const core::SubtractionPlan& plan = state.treatment.plan;
    if (plan.interval) {
        return AngiogramPanel::tr("%1 frames before each").arg(plan.interval->offset);
    }
    if (state.maskFrames.empty()) {
        return AngiogramPanel::tr("none found: mark them below");
    }
    return plan.maskFrames.empty() ? AngiogramPanel::tr("%1 (automatic)").arg(framesText(state.maskFrames))
                                   : framesText(state.maskFrames);
}

}   // namespace

AngiogramPanel::AngiogramPanel(QWidget* parent)
    : Section(tr("Angiogram"), Folding::Foldable, parent),
      subtract_(new QCheckBox(withKey(tr("Subtract mask"), Command::Subtract))),
      composite_(new QCheckBox(tr("Whole run in one picture"))),
      masks_(new ElidedLabel("label")),
      automaticMasks_(quietButton(tr("Automatic"), tr("Choose the frames before the contrast medium arrives"))),
      right_(new NumberField(shiftFormat())),
      down_(new NumberField(shiftFormat())),
      automaticShift_(quietButton(tr("Automatic"), tr("Find the shift of each frame"))),
      byHand_(quietButton(tr("By hand"), tipWithKey(tr("Move the mask with arrows or the mouse"), Command::ShiftMask))),
      relation_(new QComboBox),
      vessels_(new QComboBox),
      defaults_(quietButton(tr("Defaults"), tr("Trace as the program would by itself")))
{
    buildSubtraction();
    buildPixels();
    buildTracing();
    showRun({});
    showTracing({});
    setFolded(true);
}

template <class Change>
void AngiogramPanel::edit(const Change& change, const QString& what)
{
    core::RunTreatment wanted = state_.treatment;
    change(wanted);
    emit treatmentEdited(wanted, what);
}

void AngiogramPanel::buildSubtraction()
{
    subtract_->setToolTip(
        tipWithKey(tr("Take away what the mask frames show as well: bones and organs"), Command::Subtract));
    composite_->setToolTip(
        tipWithKey(tr("Every frame shows the darkest value of each pixel over the run"), Command::Composite));
    connect(subtract_, &QCheckBox::clicked, this, [this](bool on) {
        edit([on](core::RunTreatment& wanted) { wanted.isSubtracted = on; },
             on ? tr("Subtract mask") : tr("Show native frames"));
    });
    connect(composite_, &QCheckBox::clicked, this, [this](bool on) {
        edit([on](core::RunTreatment& wanted) { wanted.isComposite = on; },
             on ? tr("Whole run in one picture") : tr("One frame at a time"));
    });
    connect(automaticMasks_, &QPushButton::clicked, this, [this] {
        edit(
            [](core::RunTreatment& wanted) {
                wanted.plan.maskFrames.clear();
                wanted.plan.interval.reset();
            },
            tr("Choose mask frames automatically"));
    });
    connect(automaticShift_, &QPushButton::clicked, this, [this] {
        edit([](core::RunTreatment& wanted) { wanted.plan.maskShiftPx.reset(); }, tr("Find the mask's shift"));
    });
    connect(byHand_, &QPushButton::clicked, this, &AngiogramPanel::shiftByHandRequested);
    right_->setAccessibleName(tr("Mask shift to the right"));
    down_->setAccessibleName(tr("Mask shift down"));
    right_->setToolTip(tr("How far the mask moves to the right, px"));
    down_->setToolTip(tr("How far the mask moves down, px"));
    connect(right_, &NumberField::edited, this, &AngiogramPanel::editShift);
    connect(down_, &NumberField::edited, this, &AngiogramPanel::editShift);

    auto* grid = new QGridLayout;
    grid->setHorizontalSpacing(8);
    grid->setVerticalSpacing(6);
    grid->setColumnMinimumWidth(0, 84);
    grid->setColumnStretch(1, 1);
    grid->setColumnStretch(2, 1);
    grid->addWidget(roleLabel("label", tr("mask frames")), 0, 0);
    grid->addWidget(masks_, 0, 1);
    grid->addWidget(automaticMasks_, 0, 2);
    grid->addWidget(roleLabel("label", tr("shift →  ↓")), 1, 0);
    grid->addWidget(right_, 1, 1);
    grid->addWidget(down_, 1, 2);
    grid->addWidget(automaticShift_, 2, 1);
    grid->addWidget(byHand_, 2, 2);
    for (NumberField* field : {right_, down_}) {
        field->setMinimumWidth(64);
    }
    auto* checks = new QVBoxLayout;
    checks->addWidget(subtract_);
    checks->addWidget(composite_);
    contentLayout()->addLayout(checks);
    contentLayout()->addLayout(grid);
}

void AngiogramPanel::editShift()
{
    const Eigen::Vector2d shift(right_->value().value_or(0.0), down_->value().value_or(0.0));
    edit([&shift](core::RunTreatment& wanted) { wanted.plan.maskShiftPx = shift; }, tr("Move the mask"));
}

void AngiogramPanel::buildPixels()
{
    relation_->addItems({tr("linear"), tr("logarithmic")});
    relation_->setToolTip(tr("How stored values relate to the X-ray intensity (0028,1040)"));
    relation_->setAccessibleName(tr("Pixel values"));
    vessels_->addItems({tr("dark"), tr("bright")});
    vessels_->setToolTip(tr("Whether contrast medium is darker or brighter than the background"));
    vessels_->setAccessibleName(tr("Vessels"));
    connect(relation_, &QComboBox::activated, this, [this](int index) {
        edit([index](core::RunTreatment& wanted) { wanted.plan.relation = static_cast<core::PixelRelation>(index); },
             tr("Change the meaning of pixel values"));
    });
    connect(vessels_, &QComboBox::activated, this, [this](int index) {
        edit([index](core::RunTreatment& wanted) { wanted.polarity = static_cast<core::Polarity>(index); },
             index == 0 ? tr("Vessels are dark") : tr("Vessels are bright"));
    });
    auto* grid = new QGridLayout;
    grid->setHorizontalSpacing(8);
    grid->setVerticalSpacing(6);
    grid->setColumnMinimumWidth(0, 84);
    grid->setColumnStretch(1, 1);
    grid->addWidget(roleLabel("label", tr("pixel values")), 0, 0);
    grid->addWidget(relation_, 0, 1);
    grid->addWidget(roleLabel("label", tr("vessels")), 1, 0);
    grid->addWidget(vessels_, 1, 1);
    contentLayout()->addLayout(grid);
}

NumberField* AngiogramPanel::tracingRow(QGridLayout& grid, int row, const QString& label, const QString& help,
                                        const NumberFormat& format, double core::TraceOptions::*value)
{
    auto* field = new NumberField(format);
    field->setAccessibleName(label);
    field->setToolTip(help);
    grid.addWidget(roleLabel("label", label), row, 0);
    grid.addWidget(field, row, 1);
    connect(field, &NumberField::edited, this, [this, value, label](double typed) {
        core::TraceOptions wanted = tracing_;
        wanted.*value = typed;
        emit tracingEdited(wanted, tr("Change %1").arg(label));
    });
    return field;
}

NumberField* AngiogramPanel::lengthRow(QGridLayout& grid, int row)
{
    auto* field = new NumberField({0.0, 1000.0, 0, QStringLiteral("px"), 5.0});
    field->setAccessibleName(tr("shortest vessel"));
    field->setToolTip(tr("Isolated pieces shorter than this are left out; spurs shorter than a third of it too"));
    grid.addWidget(roleLabel("label", tr("shortest vessel")), row, 0);
    grid.addWidget(field, row, 1);
    connect(field, &NumberField::edited, this, [this](double typed) {
        core::TraceOptions wanted = tracing_;
        wanted.minComponentLengthPx = static_cast<int>(std::lround(typed));
        wanted.minBranchLengthPx = static_cast<int>(std::lround(typed / 3.0));
        emit tracingEdited(wanted, tr("Change %1").arg(tr("shortest vessel")));
    });
    return field;
}

void AngiogramPanel::buildTracing()
{
    auto* grid = new QGridLayout;
    grid->setHorizontalSpacing(8);
    grid->setVerticalSpacing(6);
    grid->setColumnMinimumWidth(0, 84);
    grid->setColumnStretch(1, 1);
    sensitivity_ = tracingRow(*grid, 0, tr("sensitivity"), tr("Above 1: fainter vessels are traced as well"),
                              {0.1, 10.0, 2, QString(), 0.1}, &core::TraceOptions::sensitivity);
    length_ = lengthRow(*grid, 1);
    widest_ = tracingRow(*grid, 2, tr("widest radius"), tr("Radius of the widest vessel looked for"),
                         {1.5, 40.0, 1, QStringLiteral("px"), 0.5}, &core::TraceOptions::maxVesselRadiusPx);
    connect(defaults_, &QPushButton::clicked, this,
            [this] { emit tracingEdited(core::TraceOptions{}, tr("Default tracing")); });
    QPushButton* byHand =
        quietButton(withKey(tr("Edit vessels"), Command::EditVessels),
                    tipWithKey(tr("Leave out, erase, draw and cut traced curves"), Command::EditVessels));
    connect(byHand, &QPushButton::clicked, this, &AngiogramPanel::editingRequested);
    auto* heading = new QHBoxLayout;
    heading->addWidget(roleLabel("heading", tr("Tracing")), 1);
    heading->addWidget(defaults_);
    contentLayout()->addLayout(heading);
    contentLayout()->addLayout(grid);
    contentLayout()->addWidget(byHand);
}

void AngiogramPanel::showRun(const RunState& state)
{
    state_ = state;
    const core::RunTreatment& treatment = state.treatment;
    subtract_->setChecked(treatment.isSubtracted);
    composite_->setChecked(treatment.isComposite);
    subtract_->setEnabled(state.hasRun);
    composite_->setEnabled(state.hasRun);
    for (QWidget* widget : std::initializer_list<QWidget*>{right_, down_, automaticShift_, byHand_}) {
        widget->setEnabled(state.hasRun && treatment.isSubtracted);
    }
    automaticMasks_->setEnabled(state.hasRun && (!treatment.plan.maskFrames.empty() || treatment.plan.interval));
    masks_->showText(state.hasRun ? maskText(state) : QString());
    const auto& shift = treatment.plan.maskShiftPx;
    right_->showValue(shift ? std::optional(shift->x()) : std::nullopt);
    down_->showValue(shift ? std::optional(shift->y()) : std::nullopt);
    relation_->setCurrentIndex(static_cast<int>(treatment.plan.relation));
    vessels_->setCurrentIndex(static_cast<int>(state.polarity));
    setHint(state.isComputing        ? tr("subtracting …")
            : treatment.isSubtracted ? tr("subtracted")
            : treatment.isComposite  ? tr("composite")
                                     : tr("native"));
}

void AngiogramPanel::showTracing(const core::TraceOptions& options)
{
    tracing_ = options;
    sensitivity_->showValue(options.sensitivity);
    length_->showValue(options.minComponentLengthPx);
    widest_->showValue(options.maxVesselRadiusPx);
    defaults_->setEnabled(!(options == core::TraceOptions{}));
}

}   // namespace ui
