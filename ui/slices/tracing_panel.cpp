#include "ui/slices/tracing_panel.h"

#include "ui/actions/key_hint.h"
#include "ui/controls/number_field.h"
#include "ui/slices/label_choice.h"
#include "ui/slices/mask_panel.h"
#include "ui/slices/seed_list.h"
#include "ui/words/retranslation.h"

#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QPushButton>
#include <QSignalBlocker>

namespace angiopose::ui {
namespace {

constexpr int minWidth = 250;

QLayout* withLabel(const LocalizedText& text, QWidget* field)
{
    auto* row = new QHBoxLayout;
    row->addWidget(withText(roleLabel("label"), text), 1);
    row->addWidget(field, 1);
    return row;
}

}   // namespace

TracingPanel::TracingPanel(QWidget* parent)
    : Section(
          "tracing", [] { return tr("Trace vessels"); }, Folding::Fixed, parent),
      labels_(new LabelChoice),
      mask_(new MaskPanel),
      threshold_(new ThresholdField),
      seeds_(new SeedList),
      tubes_(withToolTip(withText(new QCheckBox, [] { return tr("Thin vessels only (requires seeds)"); }),
                         [] {
                             return tr(
                                 "For coronary arteries next to opacified chambers or hepatic arteries next to the "
                                 "portal vein: tracing stops at structures wider than 1 cm. Requires seeds.");
                         })),
      path_(makeModeButton([] { return tr("Trace between two points"); }, Command::TraceBetween)),
      minLength_(new NumberField({0.0, 1000.0, 1, QStringLiteral("mm"), 1.0})),
      minRadius_(new NumberField({0.0, 1000.0, 2, QStringLiteral("mm"), 0.1})),
      components_(new QComboBox),
      keepLoops_(withText(new QCheckBox, [] { return tr("Keep loops"); })),
      trace_(withText(new QPushButton, [] { return tr("Trace"); })),
      stop_(withText(new QPushButton, [] { return tr("Stop"); })),
      note_(roleLabel("hint")),
      lumenWarning_(roleLabel("attentionBox")),
      lumenCard_(makeLumenWarning())
{
    contentLayout()->setSpacing(8);
    contentLayout()->addWidget(lumenCard_);
    contentLayout()->addWidget(labels_);
    contentLayout()->addWidget(threshold_);
    contentLayout()->addLayout(seedRows());
    contentLayout()->addLayout(limitRows());
    contentLayout()->addLayout(shapeRows());
    contentLayout()->addLayout(buttonRow());
    note_->setWordWrap(true);
    contentLayout()->addWidget(note_);
    contentLayout()->addWidget(mask_);
    contentLayout()->addStretch(1);
    setMinimumWidth(minWidth);
    reportThreshold();
    showOptions({});
    showRange(std::nullopt);
    keepTranslated(this, [this] { updateButtons(); });
}

/// Creates the warning about a second lumen with buttons that apply the remedy.
QWidget* TracingPanel::makeLumenWarning()
{
    auto* card = new QWidget;
    auto* rows = new QVBoxLayout(card);
    rows->setContentsMargins(0, 0, 0, 0);
    lumenWarning_->setWordWrap(true);
    rows->addWidget(lumenWarning_);
    auto* buttons = new QHBoxLayout;
    auto* show = withText(new QPushButton, [] { return tr("Show"); });
    auto* seed = withText(new QPushButton, [] { return tr("Add seed"); });
    withToolTip(show, [] { return tr("Shows the untraced vessel in the slices."); });
    withToolTip(seed, [] { return tr("Places a seed in this vessel and one in the traced vessel next to it."); });
    buttons->addWidget(show);
    buttons->addWidget(seed);
    buttons->addStretch(1);
    rows->addLayout(buttons);
    connect(show, &QPushButton::clicked, this, &TracingPanel::falseLumenRequested);
    connect(seed, &QPushButton::clicked, this, &TracingPanel::falseLumenSeedRequested);
    card->hide();
    return card;
}

void TracingPanel::showFalseLumen(const QString& warning)
{
    lumenWarning_->setText(warning);
    lumenCard_->setVisible(!warning.isEmpty());
}

QLayout* TracingPanel::seedRows()
{
    auto* rows = new QVBoxLayout;
    rows->setSpacing(6);
    rows->addWidget(seeds_);
    rows->addWidget(tubes_);
    rows->addWidget(path_);
    connect(seeds_, &SeedList::pickRequested, this, &TracingPanel::pickRequested);
    connect(seeds_, &SeedList::pointSelected, this, &TracingPanel::pointSelected);
    connect(seeds_, &SeedList::edited, this, [this](const SeedList::Points& seeds, const SeedList::Points& avoid) {
        options_.seedsInPatient = seeds;
        options_.avoidInPatient = avoid;
        emit optionsEdited(options_);
    });
    connect(tubes_, &QCheckBox::toggled, this, [this](bool on) {
        options_.tubesOnly = on;
        emit optionsEdited(options_);
    });
    return rows;
}

QLayout* TracingPanel::limitRows()
{
    auto* rows = new QVBoxLayout;
    rows->setSpacing(4);
    withAccessibleName(minLength_, [] { return tr("Min. length"); });
    withToolTip(minLength_, [] {
        return tr("Removes branches that extend less than this beyond the wall of their parent vessel.");
    });
    withAccessibleName(minRadius_, [] { return tr("Min. mean radius"); });
    withToolTip(minRadius_, [] { return tr("Removes branches with a smaller mean radius."); });
    rows->addLayout(withLabel([] { return tr("Min. length"); }, minLength_));
    rows->addLayout(withLabel([] { return tr("Min. mean radius"); }, minRadius_));
    connect(minLength_, &NumberField::edited, this, [this](double value) {
        options_.minBranchLengthMm = value;
        emit optionsEdited(options_);
    });
    connect(minRadius_, &NumberField::edited, this, [this](double value) {
        options_.minBranchRadiusMm = value;
        emit optionsEdited(options_);
    });
    return rows;
}

QLayout* TracingPanel::shapeRows()
{
    auto* rows = new QVBoxLayout;
    rows->setSpacing(4);
    withAccessibleName(components_, [] { return tr("Components"); });
    withToolTip(components_, [] {
        return tr(
            "Used only if there are no seeds. Default: in a mask, all components; in a scan, the component of the "
            "aorta or main artery. All: in a scan, the components of all great vessels.");
    });
    keepTranslated(components_, [this] { setItemTexts(*components_, {tr("Default"), tr("All"), tr("Largest")}); });
    withToolTip(keepLoops_,
                [] { return tr("Keeps vessel loops closed; otherwise, each loop is cut at its narrowest point."); });
    rows->addLayout(withLabel([] { return tr("Components"); }, components_));
    rows->addWidget(keepLoops_);
    connect(components_, &QComboBox::activated, this, [this](int index) {
        options_.pieces = static_cast<core::TracedPieces>(index);
        emit optionsEdited(options_);
    });
    connect(keepLoops_, &QCheckBox::clicked, this, [this](bool isKept) {
        options_.loops = isKept ? core::VesselLoops::Kept : core::VesselLoops::Opened;
        emit optionsEdited(options_);
    });
    return rows;
}

QLayout* TracingPanel::buttonRow()
{
    auto* row = new QHBoxLayout;
    trace_->setProperty("role", "primary");
    withToolTip(stop_, [] { return tr("Cancels tracing; the vessels stay unchanged."); });
    row->addWidget(trace_, 5);
    row->addWidget(stop_, 2);
    connect(trace_, &QPushButton::clicked, this, &TracingPanel::traceRequested);
    connect(stop_, &QPushButton::clicked, this, &TracingPanel::stopRequested);
    return row;
}

void TracingPanel::reportThreshold()
{
    connect(threshold_, &ThresholdField::thresholdChosen, this, [this](std::optional<double> threshold) {
        options_.threshold = threshold;
        emit optionsEdited(options_);
    });
    connect(threshold_, &ThresholdField::previewChanged, this, &TracingPanel::previewChanged);
}

void TracingPanel::bindPath(QAction& action)
{
    follow(*path_, action);
}

void TracingPanel::showOptions(const core::VesselTracingOptions& options)
{
    options_ = options;
    const QSignalBlocker quietTubes(tubes_);
    tubes_->setChecked(options.tubesOnly);
    threshold_->showManual(options.threshold);
    seeds_->showPoints(options.seedsInPatient, options.avoidInPatient);
    minLength_->showValue(options.minBranchLengthMm);
    minRadius_->showValue(options.minBranchRadiusMm);
    components_->setCurrentIndex(static_cast<int>(options.pieces));
    components_->setEnabled(options.seedsInPatient.empty());
    keepLoops_->setChecked(options.loops == core::VesselLoops::Kept);
}

void TracingPanel::showRange(std::optional<std::pair<double, double>> range, bool isHounsfield)
{
    hasValues_ = range.has_value();
    threshold_->setVisible(hasValues_);
    tubes_->setVisible(hasValues_);
    if (range) {
        threshold_->showRange(*range, isHounsfield);
    }
}

void TracingPanel::showAutomatic(std::optional<double> threshold)
{
    threshold_->showAutomatic(threshold);
}

void TracingPanel::showPick(TracingPick pick)
{
    seeds_->showPick(pick);
    updateButtons();
}

void TracingPanel::showBlockingReason(const QString& reason)
{
    blockingReason_ = reason;
    updateButtons();
}

void TracingPanel::setRunning(bool running)
{
    running_ = running;
    updateButtons();
}

bool TracingPanel::isPreviewWanted() const
{
    return threshold_->isPreviewWanted() && hasValues_;
}

std::optional<double> TracingPanel::thresholdShown() const
{
    return threshold_->shown();
}

void TracingPanel::updateButtons()
{
    trace_->setEnabled(!running_ && blockingReason_.isEmpty());
    trace_->setText(running_ ? tr("Tracing…") : tr("Trace"));
    stop_->setEnabled(running_);
    labels_->setRunning(running_);
    seeds_->setRunning(running_);
    note_->setText(!blockingReason_.isEmpty() ? blockingReason_
                   : seeds_->isPicking()      ? tr("Click in a slice to place a point; Esc ends.")
                                              : tr("The traced vessels replace the current tree; can be undone."));
}

}   // namespace angiopose::ui
