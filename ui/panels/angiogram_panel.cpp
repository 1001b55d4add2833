#include "ui/panels/angiogram_panel.h"

#include "ui/actions/key_hint.h"
#include "ui/words/retranslation.h"

#include <QCheckBox>
#include <QComboBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QPushButton>

#include <cmath>

namespace angiopose::ui {
namespace {

QPushButton* makeSmallButton(const LocalizedText& text, const LocalizedText& help)
{
    auto* button = withToolTip(withText(new QPushButton, text), help);
    button->setProperty("role", "quiet");
    return button;
}

NumberFormat shiftFormat()
{
    return {-200.0, 200.0, 2, QStringLiteral("px"), 0.25, NumberSign::Always};
}

NumberFormat grayFormat(double lowest)
{
    return {lowest, 1e9, 0, QString(), 10.0};
}

/// Formats a list of frame numbers, counted from 1.
QString framesText(const std::vector<int>& frames)
{
    QStringList parts;
    for (std::size_t i = 0; i < frames.size(); ++i) {
        const std::size_t first = i;
        while (i + 1 < frames.size() && frames[i + 1] == frames[i] + 1) {
            ++i;
        }
        parts << (i > first ? QStringLiteral("%1–%2").arg(frames[first] + 1).arg(frames[i] + 1)
                            : QString::number(frames[first] + 1));
    }
    return parts.join(QStringLiteral(", "));
}

QString maskText(const RunState& state)
{
    const core::SubtractionPlan& plan = state.processing.plan;
    if (plan.interval) {
        return AngiogramPanel::tr("%1 frames earlier").arg(plan.interval->offset);
    }
    if (state.maskFrames.empty()) {
        return AngiogramPanel::tr("none found: set them below");
    }
    return plan.maskFrames.empty() ? AngiogramPanel::tr("%1 (automatic)").arg(framesText(state.maskFrames))
                                   : framesText(state.maskFrames);
}

}   // namespace

AngiogramPanel::AngiogramPanel(QWidget* parent)
    : Section(
          "angiogram", [] { return tr("Angiogram"); }, Folding::Foldable, parent),
      window_(new NumberField(grayFormat(1e-6))),
      level_(new NumberField(grayFormat(-1e9))),
      subtract_(withText(new QCheckBox, [] { return withShortcut(tr("Subtract mask"), Command::Subtract); })),
      composite_(withText(new QCheckBox, [] { return tr("Peak-opacification image"); })),
      masks_(new ElidedLabel("label")),
      automaticMasks_(makeSmallButton([] { return tr("Automatic"); },
                                      [] { return tr("Chooses the frames before contrast arrival"); })),
      shiftRight_(new NumberField(shiftFormat())),
      shiftDown_(new NumberField(shiftFormat())),
      automaticShift_(
          makeSmallButton([] { return tr("Automatic"); }, [] { return tr("Computes the mask shift for each frame"); })),
      pixelShift_(makeSmallButton([] { return tr("Manual"); },
                                  [] {
                                      return tooltipWithShortcut(tr("Shift the mask with the arrow keys or the mouse"),
                                                                 Command::ShiftMask);
                                  })),
      relation_(new QComboBox),
      vessels_(new QComboBox),
      defaults_(
          makeSmallButton([] { return tr("Defaults"); }, [] { return tr("Restores the default tracing settings"); }))
{
    buildBrightness();
    buildSubtraction();
    buildPixels();
    buildTracing();
    showRun({});
    showTracing({}, 0.0);
    setFolded(true);
}

template <class Change>
void AngiogramPanel::edit(const Change& change, const LocalizedText& undoText)
{
    core::RunProcessing changed = state_.processing;
    change(changed);
    emit treatmentEdited(changed, undoText);
}

void AngiogramPanel::buildBrightness()
{
    withToolTip(withAccessibleName(window_, [] { return tr("Window"); }),
                [] { return tr("Window (W): range of gray values between black and white"); });
    withToolTip(withAccessibleName(level_, [] { return tr("Level"); }),
                [] { return tr("Level (L): gray value at the center of the window"); });
    for (NumberField* field : {window_, level_}) {
        field->setMinimumWidth(64);
        connect(field, &NumberField::edited, this, [this] {
            if (window_->value() && level_->value()) {
                emit windowLevelTyped(*window_->value(), *level_->value());
            }
        });
    }
    auto* row = new QHBoxLayout;
    row->setSpacing(8);
    auto* label = withText(roleLabel("label"), [] { return tr("window, level"); });
    label->setMinimumWidth(84);
    row->addWidget(label);
    row->addWidget(window_, 1);
    row->addWidget(level_, 1);
    contentLayout()->addLayout(row);
}

void AngiogramPanel::showWindowLevel(double window, double level)
{
    for (NumberField* field : {window_, level_}) {
        field->setDecimals(std::abs(window) < 10.0 ? 3 : 0);   // small ranges are those of logarithms of intensities
    }
    window_->showValue(window);
    level_->showValue(level);
}

void AngiogramPanel::buildSubtraction()
{
    withToolTip(subtract_, [] {
        return tooltipWithShortcut(
            tr("Subtracts structures that are also visible in the mask frames, such as bone and soft tissue"),
            Command::Subtract);
    });
    withToolTip(composite_, [] {
        return tooltipWithShortcut(tr("Shows the darkest value of each pixel over the run"), Command::Composite);
    });
    connect(subtract_, &QCheckBox::clicked, this, [this](bool on) {
        edit([on](core::RunProcessing& changed) { changed.isSubtracted = on; },
             [on] { return on ? tr("Subtract mask") : tr("Show native frames"); });
    });
    connect(composite_, &QCheckBox::clicked, this, [this](bool on) {
        edit([on](core::RunProcessing& changed) { changed.isComposite = on; },
             [on] { return on ? tr("Peak-opacification image") : tr("Single frames"); });
    });
    connect(automaticMasks_, &QPushButton::clicked, this, [this] {
        edit(
            [](core::RunProcessing& changed) {
                changed.plan.maskFrames.clear();
                changed.plan.interval.reset();
            },
            [] { return tr("Choose mask frames automatically"); });
    });
    connect(automaticShift_, &QPushButton::clicked, this, [this] {
        edit([](core::RunProcessing& changed) { changed.plan.maskShiftPx.reset(); },
             [] { return tr("Compute mask shift"); });
    });
    connect(pixelShift_, &QPushButton::clicked, this, &AngiogramPanel::pixelShiftRequested);
    withAccessibleName(shiftRight_, [] { return tr("Mask shift to the right"); });
    withAccessibleName(shiftDown_, [] { return tr("Mask shift down"); });
    withToolTip(shiftRight_, [] { return tr("Shifts the mask to the right, px"); });
    withToolTip(shiftDown_, [] { return tr("Shifts the mask down, px"); });
    connect(shiftRight_, &NumberField::edited, this, &AngiogramPanel::editShift);
    connect(shiftDown_, &NumberField::edited, this, &AngiogramPanel::editShift);

    auto* grid = new QGridLayout;
    grid->setHorizontalSpacing(8);
    grid->setVerticalSpacing(6);
    grid->setColumnMinimumWidth(0, 84);
    grid->setColumnStretch(1, 1);
    grid->setColumnStretch(2, 1);
    grid->addWidget(withText(roleLabel("label"), [] { return tr("mask frames"); }), 0, 0);
    grid->addWidget(masks_, 0, 1);
    grid->addWidget(automaticMasks_, 0, 2);
    grid->addWidget(withText(roleLabel("label"), [] { return tr("shift →  ↓"); }), 1, 0);
    grid->addWidget(shiftRight_, 1, 1);
    grid->addWidget(shiftDown_, 1, 2);
    grid->addWidget(automaticShift_, 2, 1);
    grid->addWidget(pixelShift_, 2, 2);
    for (NumberField* field : {shiftRight_, shiftDown_}) {
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
    const Eigen::Vector2d shift(shiftRight_->value().value_or(0.0), shiftDown_->value().value_or(0.0));
    edit([&shift](core::RunProcessing& changed) { changed.plan.maskShiftPx = shift; },
         [] { return tr("Pixel shift"); });
}

void AngiogramPanel::buildPixels()
{
    keepTranslated(relation_, [this] { setItemTexts(*relation_, {tr("linear"), tr("logarithmic")}); });
    withToolTip(relation_, [] { return tr("Relation of the stored pixel values to the X-ray intensity (0028,1040)"); });
    withAccessibleName(relation_, [] { return tr("Pixel values"); });
    keepTranslated(vessels_, [this] { setItemTexts(*vessels_, {tr("dark"), tr("bright")}); });
    withToolTip(vessels_,
                [] { return tr("Sets whether the contrast agent is darker or brighter than the background"); });
    withAccessibleName(vessels_, [] { return tr("Vessels"); });
    connect(relation_, &QComboBox::activated, this, [this](int index) {
        edit([index](core::RunProcessing& changed) { changed.plan.relation = static_cast<core::PixelRelation>(index); },
             [] { return tr("Change the interpretation of pixel values"); });
    });
    connect(vessels_, &QComboBox::activated, this, [this](int index) {
        edit([index](core::RunProcessing& changed) { changed.polarity = static_cast<core::Polarity>(index); },
             [index] { return index == 0 ? tr("Vessels are dark") : tr("Vessels are bright"); });
    });
    auto* grid = new QGridLayout;
    grid->setHorizontalSpacing(8);
    grid->setVerticalSpacing(6);
    grid->setColumnMinimumWidth(0, 84);
    grid->setColumnStretch(1, 1);
    grid->addWidget(withText(roleLabel("label"), [] { return tr("pixel values"); }), 0, 0);
    grid->addWidget(relation_, 0, 1);
    grid->addWidget(withText(roleLabel("label"), [] { return tr("vessels"); }), 1, 0);
    grid->addWidget(vessels_, 1, 1);
    contentLayout()->addLayout(grid);
}

NumberField* AngiogramPanel::tracingRow(QGridLayout& grid, int row, const LocalizedText& label,
                                        const LocalizedText& help, const NumberFormat& format,
                                        double core::TraceOptions::*value)
{
    auto* field = new NumberField(format);
    withToolTip(withAccessibleName(field, label), help);
    grid.addWidget(withText(roleLabel("label"), label), row, 0);
    grid.addWidget(field, row, 1);
    connect(field, &NumberField::edited, this, [this, value, label](double typed) {
        core::TraceOptions changed = tracing_;
        changed.*value = typed;
        emit tracingEdited(changed, [label] { return tr("Change %1").arg(label()); });
    });
    return field;
}

NumberField* AngiogramPanel::lengthRow(QGridLayout& grid, int row)
{
    auto* field = new NumberField({0.0, 1000.0, 0, QStringLiteral("px"), 5.0});
    withAccessibleName(field, [] { return tr("min. length"); });
    withToolTip(field, [] {
        return tr("Removes isolated segments shorter than this length, and spurs shorter than a third of it");
    });
    grid.addWidget(withText(roleLabel("label"), [] { return tr("min. length"); }), row, 0);
    grid.addWidget(field, row, 1);
    connect(field, &NumberField::edited, this, [this](double typed) {
        core::TraceOptions changed = tracing_;
        changed.minComponentLengthPx = static_cast<int>(std::lround(typed));
        changed.minBranchLengthPx = static_cast<int>(std::lround(typed / 3.0));
        emit tracingEdited(changed, [] { return tr("Change %1").arg(tr("min. length")); });
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
    sensitivity_ = tracingRow(
        *grid, 0, [] { return tr("sensitivity"); }, [] { return tr("Above 1, fainter vessels are also traced"); },
        {0.1, 10.0, 2, QString(), 0.1}, &core::TraceOptions::sensitivity);
    length_ = lengthRow(*grid, 1);
    maxRadius_ = tracingRow(
        *grid, 2, [] { return tr("max. radius"); }, [] { return tr("Radius of the widest vessel to trace"); },
        {1.5, 40.0, 1, QStringLiteral("px"), 0.5}, &core::TraceOptions::maxVesselRadiusPx);
    connect(defaults_, &QPushButton::clicked, this,
            [this] { emit tracingEdited(core::TraceOptions{}, [] { return tr("Restore default tracing"); }); });
    QPushButton* byHand = makeSmallButton(
        [] { return withShortcut(tr("Edit vessels"), Command::EditVessels); },
        [] { return tooltipWithShortcut(tr("Exclude, erase, draw and cut traced curves"), Command::EditVessels); });
    connect(byHand, &QPushButton::clicked, this, &AngiogramPanel::editingRequested);
    auto* heading = new QHBoxLayout;
    heading->addWidget(withText(roleLabel("heading"), [] { return tr("Tracing"); }), 1);
    heading->addWidget(defaults_);
    contentLayout()->addLayout(heading);
    contentLayout()->addLayout(grid);
    contentLayout()->addWidget(byHand);
}

void AngiogramPanel::showRun(const RunState& state)
{
    state_ = state;
    const core::RunProcessing& processing = state.processing;
    subtract_->setChecked(processing.isSubtracted);
    composite_->setChecked(processing.isComposite);
    subtract_->setEnabled(state.hasRun);
    composite_->setEnabled(state.hasRun);
    for (QWidget* widget : std::initializer_list<QWidget*>{shiftRight_, shiftDown_, automaticShift_, pixelShift_}) {
        widget->setEnabled(state.hasRun && processing.isSubtracted);
    }
    automaticMasks_->setEnabled(state.hasRun && (!processing.plan.maskFrames.empty() || processing.plan.interval));
    masks_->showText(state.hasRun ? maskText(state) : QString());
    const auto& shift = processing.plan.maskShiftPx;
    shiftRight_->showValue(shift ? std::optional(shift->x()) : std::nullopt);
    shiftDown_->showValue(shift ? std::optional(shift->y()) : std::nullopt);
    relation_->setCurrentIndex(static_cast<int>(processing.plan.relation));
    vessels_->setCurrentIndex(static_cast<int>(state.polarity));
    setHint(state.isComputing         ? tr("subtracting…")
            : processing.isSubtracted ? tr("subtracted")
            : processing.isComposite  ? tr("MinIP")
                                      : tr("native"));
}

void AngiogramPanel::showTracing(const core::TraceOptions& options, double maxWidthPx)
{
    tracing_ = options;
    sensitivity_->showValue(options.sensitivity);
    length_->showValue(options.minComponentLengthPx);
    maxRadius_->showValue(maxWidthPx);
    defaults_->setEnabled(!(options == core::TraceOptions{}));
}

}   // namespace angiopose::ui
