#include "core/registration/deformable/deformation_tracker.h"

#include "core/registration/deformable/classify_deformation.h"
#include "core/registration/deformable/deformed_result.h"
#include "core/registration/deformable/evidence_gain.h"
#include "core/support/stopwatch.h"
#include "core/vessel/polyline.h"

#include <algorithm>
#include <array>
#include <span>
#include <utility>

namespace angiopose::core {
namespace {

constexpr double warmStrain = 0.15;
constexpr std::array<double, 5> warmAnnealingMm{1.0, 0.6, 0.35, 0.2, 0.1};
constexpr std::size_t warmLearningFrom = 1;
constexpr double warmCoarseAboveMm = 0.5;
constexpr double warmDeviationMm = 1.5;   // 1-σ motion between frames, relative to the tracked rigid pose
constexpr double minRelativeMatched = 0.8;   // minimum matched tree length, relative to the last frame

/// Interpolates the motion of a branch's points to its evenly spaced knots.
Eigen::Matrix3Xd motionAtKnots(const TreeKnots& knots, const VesselTree& tree, const DeformableResult& previous)
{
    Eigen::Matrix3Xd motion = Eigen::Matrix3Xd::Zero(3, static_cast<Eigen::Index>(knots.size()));
    for (std::size_t b = 0; b < tree.branches.size(); ++b) {
        const std::size_t first = knots.firstOfBranch[b];
        const std::size_t count = knots.firstOfBranch[b + 1] - first;
        const auto& points = tree.branches[b].pointsInPatient;
        const double spacing = polylineLength<3>(points) / std::max(1.0, static_cast<double>(count) - 1.0);
        const auto found = interpolate(previous.branches[b].displacementMm, evenStations<3>(points, spacing));
        for (std::size_t k = 0; k < std::min(count, found.size()); ++k) {
            motion.col(static_cast<Eigen::Index>(first + k)) = found[k];
        }
    }
    return motion;
}

}   // namespace

DeformationTracker::DeformationTracker(DeformationProblem problem, DeformableResult previous,
                                       const RigidTransform& rigid, const DeformableOptions& options)
    : options_(options), problem_(std::move(problem)), lastResult_(std::move(previous)), lastRigidPose_(rigid)
{
}

Result<DeformationTracker> DeformationTracker::after(const DeformableView& view, DeformableResult previous,
                                                     const DeformableOptions& options)
{
    auto problem = makeDeformationProblem(std::span(&view, 1), options);
    if (!problem) {
        return problem.error();
    }
    return DeformationTracker(std::move(problem).value(), std::move(previous), view.rigidCameraFromPatient, options);
}

/// Returns the last frame's deformation, moved with the rigid pose.
DeformationState DeformationTracker::shiftedInitialState(const DeformableView& view) const
{
    const RigidTransform carried =
        view.rigidCameraFromPatient * lastRigidPose_.inverse() * lastResult_.cameraFromPatient;
    DeformationState state = initialState(problem_, warmStrain);
    state.poseStep = stepBetween(problem_.start, aboutCentroid(carried, problem_.centroidInPatient));
    state.motionMm = motionAtKnots(problem_.knots, view.input.tree, lastResult_);
    state.deviationMm.setConstant(warmDeviationMm);
    state.noisePx = std::max(lastResult_.noisePx, 0.5);
    if (variances_) {
        state.variances = *variances_;
    }
    return state;
}

DeformableResult DeformationTracker::makeWarmStart(const DeformableView& view)
{
    std::vector<DeformationFit> fits{DeformationFit(problem_, shiftedInitialState(view))};
    DeformationFit& fit = fits.front();
    for (std::size_t k = 0; k < warmAnnealingMm.size(); ++k) {
        fit.step({warmAnnealingMm[k], warmStrain, k >= warmLearningFrom, warmAnnealingMm[k] > warmCoarseAboveMm});
    }
    const std::span views(&view, 1);
    DeformableResult result = deformedResult(views, problem_, fits, 0);
    result.logEvidenceGain = fit.posterior() ? logEvidenceGain(problem_, fit) : 0.0;
    result.iterations = static_cast<int>(warmAnnealingMm.size());
    classifyDeformation(views, result);
    variances_ = fit.state().variances;
    return result;
}

Result<DeformableResult> DeformationTracker::next(const DeformableView& view, const IterationObserver& observe)
{
    Stopwatch stopwatch;
    if (const Status status = replaceView(problem_, view, options_); !status) {
        return status.error();
    }
    DeformableResult result = makeWarmStart(view);
    if (result.explainedShare < minRelativeMatched * lastResult_.explainedShare) {
        auto cold = deformVessels(std::span(&view, 1), options_, observe);
        if (!cold) {
            return cold.error();
        }
        if (cold.value().explainedShare > result.explainedShare) {
            result = std::move(cold).value();
            variances_.reset();
        }
    }
    result.timeMs = stopwatch.takeLapMs();
    lastResult_ = result;
    lastRigidPose_ = view.rigidCameraFromPatient;
    return result;
}

}   // namespace angiopose::core
