#include "ui/panels/result_panel.h"

#include "core/registration/deformation_check.h"
#include "ui/controls/stable_minimum_height.h"
#include "ui/panels/result_sentences.h"
#include "ui/plots/convergence_plot.h"
#include "ui/plots/histogram_plot.h"
#include "ui/words/language.h"
#include "ui/words/message_text.h"
#include "ui/words/number.h"
#include "ui/words/retranslation.h"
#include "ui/words/terms.h"

#include <QGraphicsOpacityEffect>
#include <QHBoxLayout>
#include <QTimer>

#include <algorithm>

namespace angiopose::ui {
namespace {

QLabel* makeSentenceBox(const char* role)
{
    QLabel* label = roleLabel(role);
    label->setWordWrap(true);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    label->hide();
    return label;
}

void setSentences(QLabel* box, const QStringList& sentences)
{
    box->setText(joinSentences(sentences));
    box->setVisible(!sentences.isEmpty());
}

/// Keeps the layout stable while sentences appear and disappear as the user moves the pose.
void reserveHeight(QLabel* box, bool isKept)
{
    const int heightPx = isKept && box->isVisible() ? box->height() : box->minimumHeight();
    box->setMinimumHeight(isKept ? std::max(box->minimumHeight(), heightPx) : 0);
    QSizePolicy policy = box->sizePolicy();
    policy.setRetainSizeWhenHidden(isKept && box->minimumHeight() > 0);
    box->setSizePolicy(policy);
}

QString runSummary(const core::RegistrationResult& result)
{
    const QString sentence = termText(core::toText(result.stopReason));
    const double ms = result.time.totalMs;
    const QString time = ms >= 1000.0 ? ResultPanel::tr("%1 s").arg(numberText(ms / 1000.0, 1))
                                      : ResultPanel::tr("%1 ms").arg(numberText(ms, ms < 10.0 ? 1 : 0));
    return ResultPanel::tr("%1 · %2").arg(sentence, time);
}

QString sourceText(const AssessedPose& assessed)
{
    const QString median = ResultPanel::tr("%1 px").arg(numberText(assessed.result.metrics.medianPx, 2));
    switch (assessed.source) {
        case PoseSource::Run:
            return ResultPanel::tr("%1 · %2").arg(median, runSummary(assessed.result));
        case PoseSource::Edited:
            return ResultPanel::tr("%1 · moved manually").arg(median);
        case PoseSource::EarlierRegistration:
            return ResultPanel::tr("%1 · from an earlier registration").arg(median);
        case PoseSource::Tracked:
            return ResultPanel::tr("%1 · tracked").arg(median);
        case PoseSource::Start:
            break;
    }
    return ResultPanel::tr("%1 · initial pose").arg(median);
}

/// Formats the median, e.g. "median 0.26 mm"; if only part of the tree is assessed, adds the median of the whole tree.
QString medianText(const AssessedPose& assessed)
{
    const QString median = numberText(assessed.result.metrics.medianMm, 2);
    return assessed.assessedFraction < 1.0
               ? ResultPanel::tr("median %1 mm over the %2 % classified as opacified, %3 mm over the whole tree")
                     .arg(median, numberText(100.0 * assessed.assessedFraction, 0),
                          numberText(assessed.wholeMedianMm, 2))
               : ResultPanel::tr("median %1 mm").arg(median);
}

/// Describes the origin of a pose; empty for the latest registration and for tracked poses.
QString originText(PoseSource source)
{
    switch (source) {
        case PoseSource::Edited:
            return ResultPanel::tr("Moved manually, not registered");
        case PoseSource::EarlierRegistration:
            return ResultPanel::tr("Inputs have changed since this registration");
        case PoseSource::Start:
            return ResultPanel::tr("Initial pose, not registered");
        case PoseSource::Run:
        case PoseSource::Tracked:
            break;
    }
    return {};
}

}   // namespace

FitVerdict assessFit(const AssessedPose& assessed)
{
    const QString origin = originText(assessed.source);
    if (assessed.source == PoseSource::Start) {
        return {VerdictTone::Doubtful, origin};
    }
    const QString median = medianText(assessed);
    if (!assessed.result.trustworthy) {
        const QString reported = ResultPanel::tr("NOT RELIABLE · %1").arg(median);
        return {VerdictTone::Bad, origin.isEmpty() ? reported : reported + QStringLiteral(" · ") + origin};
    }
    if (!origin.isEmpty()) {
        return {VerdictTone::Doubtful, origin + QStringLiteral(" · ") + median};
    }
    return {VerdictTone::Good, ResultPanel::tr("All checks passed · %1").arg(median)};
}

ResultPanel::ResultPanel(QWidget* parent)
    : QWidget(parent),
      section_(new Section(
          "result", [] { return tr("Result"); }, Folding::Fixed)),
      solutions_(new SolutionStrip),
      residualSection_(new Section(
          "residuals", [] { return tr("Residuals"); }, Folding::Foldable)),
      convergenceSection_(new Section(
          "convergence", [] { return tr("Convergence"); }, Folding::Foldable)),
      motionSection_(new Section(
          "motion", [] { return tr("Motion"); }, Folding::Foldable)),
      verdict_(makeSentenceBox("errorBox")),
      certainLabel_(makeSentenceBox("fineBox")),
      doubtfulLabel_(makeSentenceBox("attentionBox")),
      histogram_(new HistogramPlot),
      convergence_(new ConvergencePlot),
      motion_(new MotionPlot),
      idleTimer_(new QTimer(this))
{
    idleTimer_->setSingleShot(true);
    idleTimer_->setInterval(shrinkDelayMs);
    connect(idleTimer_, &QTimer::timeout, this, [this] { reserveSpace(false); });
    section_->contentLayout()->addWidget(verdict_);
    auto* numbers = new QHBoxLayout;
    numbers->setSpacing(4);
    numbers->addWidget(makeNumber(
                           median_, [] { return tr("median, mm"); },
                           [] { return tr("Median distance of the vessel points classified as opacified."); }),
                       1);
    numbers->addWidget(
        makeNumber(
            p95_, [] { return tr("P95, mm"); },
            [] { return tr("95th percentile of the distances of the vessel points classified as opacified."); }),
        1);
    numbers->addWidget(makeNumber(
                           coverage_, [] { return tr("coverage"); },
                           [] { return tr("Share of the traced vessel length that lies within 3 px of the tree."); }),
                       1);
    section_->contentLayout()->addLayout(numbers);
    section_->contentLayout()->addWidget(certainLabel_);
    section_->contentLayout()->addWidget(doubtfulLabel_);
    withToolTip(certainLabel_, [] { return tr("± is one standard deviation."); });
    withToolTip(doubtfulLabel_, [] { return tr("± is one standard deviation."); });

    keepTranslated(this, [this] {
        residualSection_->setHint(tr("mm, points classified as opacified"));
        motionSection_->setHint(tr("in-plane (mm), by frame"));
    });
    residualSection_->contentLayout()->addWidget(histogram_);
    convergenceSection_->contentLayout()->addWidget(convergence_);
    motionSection_->contentLayout()->addWidget(motion_);

    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(section_);
    layout->addWidget(solutions_);
    layout->addWidget(motionSection_);
    layout->addWidget(residualSection_);
    layout->addWidget(convergenceSection_);
    showMotion({});
    showNothing(tr("nothing to assess yet"));
}

void ResultPanel::showMotion(const std::vector<FrameMotion>& motion)
{
    motion_->showMotion(motion);
    motionSection_->setVisible(!motion.empty());
}

QWidget* ResultPanel::makeNumber(QLabel*& value, const LocalizedText& caption, const LocalizedText& toolTip)
{
    auto* cell = withToolTip(new QWidget, toolTip);
    value = withAccessibleName(roleLabel("bigNumber"), caption);
    auto* layout = new QVBoxLayout(cell);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(value);
    layout->addWidget(withText(roleLabel("hint"), caption));
    return cell;
}

void ResultPanel::showAssessment(const AssessedPose& assessed, const core::VesselTree& tree)
{
    const core::DistanceMetrics& metrics = assessed.result.metrics;
    median_->setText(numberText(metrics.medianMm, 2));
    p95_->setText(numberText(metrics.p95Mm, 2));
    coverage_->setText(tr("%1 %").arg(numberText(100.0 * metrics.coverage, 0)));
    const bool isLow = assessed.source != PoseSource::Start && !assessed.result.trustworthy;
    for (QLabel* number : {median_, p95_, coverage_}) {
        setRole(number, isLow ? "bigNumberDoubtful" : "bigNumber");
    }
    setSentences(verdict_, isLow ? QStringList{assessFit(assessed).sentence} : QStringList());
    section_->setHint(sourceText(assessed));
    showSentences(assessed, tree);
    histogram_->showValues(assessed.residualsMm, assessed.scaleMaximumMm);
}

void ResultPanel::showSentences(const AssessedPose& assessed, const core::VesselTree& tree)
{
    reserveSpace(assessed.source == PoseSource::Edited);
    if (assessed.source == PoseSource::Start) {
        setSentences(certainLabel_, {});
        setSentences(doubtfulLabel_, {tr("Initial pose, not registered yet. Press R to register, N to nudge.")});
        return;
    }
    const ResultSentences sentences = sentencesOf(assessed.result, tree, assessed.millimetersPerPixel);
    setSentences(certainLabel_, sentences.certain);
    QStringList doubtful;
    for (const core::Message& sentence : assessed.basis) {
        doubtful << messageText(sentence);
    }
    const auto against = std::ranges::count_if(assessed.result.warnings, core::lowersConfidence);
    doubtful = sentences.doubtful.first(against) + doubtful + sentences.doubtful.sliced(against);
    const bool isOld = assessed.source == PoseSource::EarlierRegistration;
    setSentences(doubtfulLabel_,
                 isOld
                     ? doubtful + QStringList{tr("The inputs have changed since this registration. Press R to update.")}
                     : doubtful);
}

void ResultPanel::reserveSpace(bool isReserved)
{
    for (QLabel* box : {certainLabel_, doubtfulLabel_}) {
        reserveHeight(box, isReserved);
    }
    isReserved ? idleTimer_->start() : idleTimer_->stop();
}

void ResultPanel::showNothing(const QString& why)
{
    for (QLabel* label : {median_, p95_, coverage_}) {
        label->setText(QStringLiteral("–"));
    }
    section_->setHint(why);
    reserveSpace(false);
    setSentences(verdict_, {});
    setSentences(certainLabel_, {});
    setSentences(doubtfulLabel_, {});
    histogram_->showValues({}, 0.0);
}

void ResultPanel::setDimmed(bool dimmed)
{
    for (QWidget* part : {static_cast<QWidget*>(section_), static_cast<QWidget*>(residualSection_)}) {
        if (dimmed != (part->graphicsEffect() != nullptr)) {
            auto* const effect = dimmed ? new QGraphicsOpacityEffect(part) : nullptr;
            if (effect) {
                effect->setOpacity(0.35);
            }
            part->setGraphicsEffect(effect);
        }
    }
}

void ResultPanel::startRun()
{
    convergence_->showHistory({});
}

void ResultPanel::showProgress(const core::IterationReport& report)
{
    convergence_->append(report);
    convergenceSection_->setHint(tr("step %1").arg(report.iteration));
}

void ResultPanel::showHistory(const std::vector<core::IterationReport>& history)
{
    convergence_->showHistory(history);
    if (history.empty()) {
        convergenceSection_->setHint({});
        return;
    }
    convergenceSection_->setHint(tr("%1 → %2 px · steps: %3")
                                     .arg(numberText(history.front().medianDistancePx, 1))
                                     .arg(numberText(history.back().medianDistancePx, 1))
                                     .arg(history.size()));
}

}   // namespace angiopose::ui
