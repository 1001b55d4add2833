#include "app/review/judgement_controller.h"

#include "app/review/followed_pose.h"
#include "app/texts/fit_words.h"
#include "app/texts/overlay_picture.h"
#include "core/case/registration_input.h"
#include "ui/panels/result_sentences.h"
#include "ui/words/message_text.h"

#include <algorithm>
#include <chrono>

namespace angiopose::app {
namespace {

std::vector<double> residualsMm(const std::vector<int>& excludedBranchIds,
                                const std::vector<core::UnopacifiedBranch>& unopacified,
                                const core::PoseJudgement& judgement, double millimetersPerPixel)
{
    std::vector<double> residuals;
    for (const auto& [branchId, distancesPx] : judgement.residualPx) {
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

/// Returns the target of the evaluation. After a wire registration it includes the wire, because the branches along the
/// wire match the wire and not the traced vessels.
core::Centerline2d judgedTarget(const core::View& view, const core::Centerline2d& vessels)
{
    const auto devices = core::devicesOf(view);
    const bool isFollowed = devices && view.result && view.result->method == "wire";
    return isFollowed ? core::together({vessels, *devices}) : vessels;
}

}   // namespace

JudgementController::JudgementController(const Parts& parts, QObject* parent)
    : QObject(parent), on_(parts), job_(restBetween)
{
    connect(&job_, &JudgeJob::judged, this, [this](const SharedJudgement& judgement) {
        judgement_ = judgement;
        show();
        emit judged(judgement);
    });
    connect(&job_, &JudgeJob::failed, this, [this](const core::Message& reason) {
        judgement_.reset();
        show();
        on_.panel.showNothing(ui::messageText(reason));
    });
}

void JudgementController::judge(const core::RigidTransform& cameraFromPatient)
{
    const SharedCenterline target = on_.target.current();
    const bool isHidden = on_.document.isInTrial();   // the observer of a blind trial must not see the verdict
    if (!target || !on_.pose.currentOffset() || isHidden) {
        job_.cancel();
        judgement_.reset();
        return;
    }
    const core::Case& current = on_.document.current();
    if (auto input = core::registrationInputOf(current, judgedTarget(current.shown(), *target))) {
        job_.request({std::move(input).value(), cameraFromPatient});
    }
}

void JudgementController::show()
{
    const core::Case& current = on_.document.current();
    on_.panel.showHistory(current.shown().result ? current.shown().result->history
                                                 : std::vector<core::IterationReport>{});
    const auto camera = core::cameraOf(current.shown());
    if (!judgement_ || !camera || !current.vessels.tree || on_.registration.isRunning()) {
        showNothing();
        return;
    }
    const ui::JudgedPose judged = judgedPose(camera.value());
    on_.sync.showJudgement(judgement_);
    on_.look.knowResiduals(judged.result.branches, judged.millimetersPerPixel);
    on_.replay.knowUncertainty(judged.result.uncertainty);
    on_.posePanel.showDepthDoubt(
        judged.source == ui::PoseSource::Start ? std::nullopt : ui::doubtfulDepthMm(judged.result.uncertainty));
    on_.panel.showJudgement(judged, *current.vessels.tree);
    const ui::FitVerdict verdict = ui::verdictOf(judged);
    on_.sync.showVerdict(verdict.tone, verdict.words);
}

void JudgementController::showNothing()
{
    on_.posePanel.showDepthDoubt(std::nullopt);
    on_.look.knowResiduals({}, 0.0);
    on_.replay.knowUncertainty(std::nullopt);
    on_.sync.showJudgement(nullptr);
    on_.sync.showVerdict(ui::VerdictTone::Doubtful, {});
    if (!on_.registration.isRunning()) {
        const auto& problem = on_.target.problem();
        on_.panel.showNothing(problem ? ui::messageText(*problem) : tr("nothing to assess yet"));
    }
}

ui::JudgedPose JudgementController::judgedPose(const core::ProjectionCamera& camera) const
{
    const core::Case& current = on_.document.current();
    const double depthMm = (current.shown().cameraFromPatient * core::centroidInPatient(*current.vessels.tree)).z();
    const double shownDepthMm = std::max(depthMm, core::minProjectableDepthMm);
    ui::JudgedPose judged;
    judged.result = judgement_->result;
    judged.source = sourceOf(takeWordOfRun(judged.result, current.shown()));
    judged.millimetersPerPixel = core::millimetersPerPixel(camera, shownDepthMm);
    judged.scaleMaximumMm = residualScaleMaximumPx(camera, shownDepthMm) * judged.millimetersPerPixel;
    if (const auto basis = core::fitBasis(current, judged.result, judgement_->residualPx)) {
        judged.judgedShare = basis->judgedShare;
        judged.wholeMedianMm = basis->wholeMedianMm;
        judged.basis = fitWords(*basis, current.vessels);
    }
    judged.residualsMm = residualsMm(current.vessels.excludedBranchIds, judged.result.unopacified, *judgement_,
                                     judged.millimetersPerPixel);
    return judged;
}

ui::PoseSource JudgementController::sourceOf(FoundBy found) const
{
    if (found == FoundBy::ItsRun) {
        return ui::PoseSource::Run;
    }
    return followedPoseShown(on_.document.current().shown()) ? ui::PoseSource::Followed
           : found == FoundBy::AnEarlierRun                  ? ui::PoseSource::EarlierRun
           : on_.pose.isMovedFromStart()                     ? ui::PoseSource::Edited
                                                             : ui::PoseSource::Start;
}

}   // namespace angiopose::app
