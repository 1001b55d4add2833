#include "app/review/evaluation_controller.h"

#include "app/review/tracked_pose.h"
#include "app/texts/fit_basis_lines.h"
#include "app/texts/overlay_image.h"
#include "core/case/registration_input.h"
#include "ui/panels/result_sentences.h"
#include "ui/words/message_text.h"

#include <algorithm>
#include <chrono>

namespace angiopose::app {
namespace {

std::vector<double> residualsMm(const std::vector<int>& excludedBranchIds,
                                const std::vector<core::UnopacifiedBranch>& unopacified,
                                const core::PoseEvaluation& evaluation, double millimetersPerPixel)
{
    std::vector<double> residuals;
    for (const auto& [branchId, distancesPx] : evaluation.residualPx) {
        if (std::ranges::find(excludedBranchIds, branchId) != excludedBranchIds.end() ||
            std::ranges::find(unopacified, branchId, &core::UnopacifiedBranch::branchId) != unopacified.end()) {
            continue;
        }
        for (const double distancePx : distancesPx) {
            residuals.push_back(distancePx * millimetersPerPixel);
        }
    }
    return residuals;
}

constexpr auto restBetween =
    std::chrono::milliseconds(60);   ///< pause between evaluations, so that drawing keeps up with dragging

/// Returns the target of the evaluation. After a wire registration, the target includes the wire, because the branches
/// along the wire match it rather than the traced vessels.
core::Centerline2d judgedTarget(const core::View& view, const core::Centerline2d& vessels)
{
    const auto devices = core::devicesOf(view);
    const bool isFollowed = devices && view.result && view.result->method == "wire";
    return isFollowed ? core::allCurves({vessels, *devices}) : vessels;
}

}   // namespace

EvaluationController::EvaluationController(const Parts& parts, QObject* parent)
    : QObject(parent), parts_(parts), job_(restBetween)
{
    connect(&job_, &EvaluationJob::evaluated, this, [this](const SharedEvaluation& evaluation) {
        evaluation_ = evaluation;
        show();
        emit evaluated(evaluation);
    });
    connect(&job_, &EvaluationJob::failed, this, [this](const core::Message& reason) {
        evaluation_.reset();
        show();
        parts_.panel.showNothing(ui::messageText(reason));
    });
}

void EvaluationController::evaluate(const core::RigidTransform& cameraFromPatient)
{
    const SharedCenterline target = parts_.target.current();
    const bool isHidden = parts_.document.isInTrial();   // the observer of a blind trial must not see the verdict
    if (!target || !parts_.pose.currentOffset() || isHidden) {
        job_.cancel();
        evaluation_.reset();
        return;
    }
    const core::Case& current = parts_.document.current();
    if (auto input = core::makeRegistrationInput(current, judgedTarget(current.shown(), *target))) {
        job_.request({std::move(input).value(), cameraFromPatient});
    }
}

void EvaluationController::show()
{
    const core::Case& current = parts_.document.current();
    parts_.panel.showHistory(current.shown().result ? current.shown().result->history
                                                    : std::vector<core::IterationReport>{});
    const auto camera = core::cameraOf(current.shown());
    if (!evaluation_ || !camera || !current.vessels.tree || parts_.registration.isRunning()) {
        showNothing();
        return;
    }
    const ui::AssessedPose evaluated = evaluatedPose(camera.value());
    parts_.sync.showAssessment(evaluation_);
    parts_.overlayStyle.setResiduals(evaluated.result.branches, evaluated.millimetersPerPixel);
    parts_.replay.setUncertainty(evaluated.result.uncertainty);
    parts_.posePanel.showDepthUncertainty(
        evaluated.source == ui::PoseSource::Start ? std::nullopt : ui::uncertainDepthMm(evaluated.result.uncertainty));
    parts_.panel.showAssessment(evaluated, *current.vessels.tree);
    const ui::FitVerdict verdict = ui::assessFit(evaluated);
    parts_.sync.showVerdict(verdict.tone, verdict.sentence);
}

void EvaluationController::showNothing()
{
    parts_.posePanel.showDepthUncertainty(std::nullopt);
    parts_.overlayStyle.setResiduals({}, 0.0);
    parts_.replay.setUncertainty(std::nullopt);
    parts_.sync.showAssessment(nullptr);
    parts_.sync.showVerdict(ui::VerdictTone::Doubtful, {});
    if (!parts_.registration.isRunning()) {
        const auto& problem = parts_.target.problem();
        parts_.panel.showNothing(problem ? ui::messageText(*problem) : tr("nothing to assess yet"));
    }
}

ui::AssessedPose EvaluationController::evaluatedPose(const core::ProjectionCamera& camera) const
{
    const core::Case& current = parts_.document.current();
    const double depthMm = (current.shown().cameraFromPatient * core::centroidInPatient(*current.vessels.tree)).z();
    const double shownDepthMm = std::max(depthMm, core::minProjectableDepthMm);
    ui::AssessedPose evaluated;
    evaluated.result = evaluation_->result;
    evaluated.source = sourceOf(addRegistrationResult(evaluated.result, current.shown()));
    evaluated.millimetersPerPixel = core::millimetersPerPixel(camera, shownDepthMm);
    evaluated.scaleMaximumMm = residualScaleMaximumPx(camera, shownDepthMm) * evaluated.millimetersPerPixel;
    if (const auto basis = core::fitBasis(current, evaluated.result, evaluation_->residualPx)) {
        evaluated.assessedFraction = basis->assessedFraction;
        evaluated.wholeMedianMm = basis->wholeMedianMm;
        evaluated.basis = fitBasisLines(*basis, current.vessels);
    }
    evaluated.residualsMm = residualsMm(current.vessels.excludedBranchIds, evaluated.result.unopacified, *evaluation_,
                                        evaluated.millimetersPerPixel);
    return evaluated;
}

ui::PoseSource EvaluationController::sourceOf(PoseOrigin found) const
{
    if (found == PoseOrigin::Registration) {
        return ui::PoseSource::Run;
    }
    return shownTrackedPose(parts_.document.current().shown()) ? ui::PoseSource::Tracked
           : found == PoseOrigin::EarlierRegistration          ? ui::PoseSource::EarlierRegistration
           : parts_.pose.differsFromInitialPose()              ? ui::PoseSource::Edited
                                                               : ui::PoseSource::Start;
}

}   // namespace angiopose::app
