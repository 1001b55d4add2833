#include "core/registration/deformable/smooth_deformations.h"

#include "core/registration/deformable/deformed_tree.h"

#include <Eigen/LU>
#include <algorithm>

namespace angiopose::core {
namespace {

constexpr int learningRounds = 4;
constexpr double firstStepMm2 = 0.25;   // initial variance of a point's frame-to-frame step, per axis
constexpr double minStepMm2 = 1e-4;
constexpr double minNoiseMm2 = 1e-4;

/// Observed positions of one vessel point over the frames, patient axes at the rigid pose of each frame, mm.
struct PointTrack {
    std::vector<Eigen::Vector3d> seen;
    std::vector<Eigen::Matrix3d> covariance;
};

/// Smoothed point track with its step statistics.
struct SmoothTrack {
    std::vector<Eigen::Vector3d> positions;
    double squaredSteps = 0.0;   ///< sum of the expected squared steps per axis and frame interval
};

SmoothTrack smoothed(const PointTrack& track, const std::vector<double>& intervals, double stepMm2)
{
    const std::size_t count = track.seen.size();
    std::vector<Eigen::Vector3d> filtered(count);
    std::vector<Eigen::Matrix3d> variance(count);
    filtered[0] = track.seen[0];
    variance[0] = track.covariance[0];
    for (std::size_t t = 1; t < count; ++t) {
        const Eigen::Matrix3d predicted = variance[t - 1] + stepMm2 * intervals[t] * Eigen::Matrix3d::Identity();
        const Eigen::Matrix3d gain = predicted * (predicted + track.covariance[t]).inverse();
        filtered[t] = filtered[t - 1] + gain * (track.seen[t] - filtered[t - 1]);
        variance[t] = (Eigen::Matrix3d::Identity() - gain) * predicted;
    }
    SmoothTrack smooth{filtered, 0.0};
    for (std::size_t t = count - 1; t > 0; --t) {
        const Eigen::Matrix3d step = stepMm2 * intervals[t] * Eigen::Matrix3d::Identity();
        const Eigen::Matrix3d back = variance[t - 1] * (variance[t - 1] + step).inverse();
        const Eigen::Matrix3d later = variance[t];
        smooth.positions[t - 1] = filtered[t - 1] + back * (smooth.positions[t] - filtered[t - 1]);
        variance[t - 1] += back * (later - variance[t - 1] - step) * back.transpose();
        const Eigen::Matrix3d both = later + variance[t - 1] - back * later - (back * later).transpose();
        const Eigen::Vector3d way = smooth.positions[t] - smooth.positions[t - 1];
        smooth.squaredSteps += (way.squaredNorm() + both.trace()) / (3.0 * intervals[t]);
    }
    return smooth;
}

PointTrack trackOf(const std::vector<TimedDeformation>& deformations, const std::vector<VesselTree>& deformed,
                   const VesselTree& tree, std::size_t branch, std::size_t point)
{
    PointTrack track;
    for (std::size_t t = 0; t < deformations.size(); ++t) {
        const Eigen::Matrix3d& rotation = deformations[t].rigidCameraFromPatient.rotation;
        const BranchMotion& motion = *findMotion(*deformations[t].deformed, tree.branches[branch].id);
        track.seen.emplace_back(deformed[t].branches[branch].pointsInPatient[point]);
        track.covariance.emplace_back(rotation.transpose() * motion.covariance[point] * rotation +
                                      minNoiseMm2 * Eigen::Matrix3d::Identity());
    }
    return track;
}

std::vector<PointTrack> tracksOf(const std::vector<TimedDeformation>& deformations, const VesselTree& tree)
{
    std::vector<VesselTree> deformed;
    for (const TimedDeformation& each : deformations) {
        deformed.push_back(deformedTreeAt(tree, *each.deformed, each.rigidCameraFromPatient));
    }
    std::vector<PointTrack> tracks;
    for (std::size_t b = 0; b < tree.branches.size(); ++b) {
        for (std::size_t i = 0; i < tree.branches[b].pointsInPatient.size(); ++i) {
            tracks.push_back(trackOf(deformations, deformed, tree, b, i));
        }
    }
    return tracks;
}

/// Returns the number of frames since the previous entry; 1 throughout if no frame is missing.
std::vector<double> frameIntervals(const std::vector<TimedDeformation>& deformations)
{
    std::vector<double> intervals{0.0};
    for (std::size_t t = 1; t < deformations.size(); ++t) {
        intervals.push_back(std::max(1.0, static_cast<double>(deformations[t].frame - deformations[t - 1].frame)));
    }
    return intervals;
}

/// Estimates the step variance by expectation maximization over all points.
double estimateStepVariance(const std::vector<PointTrack>& tracks, const std::vector<double>& intervals)
{
    double step = firstStepMm2;
    const double steps = static_cast<double>(tracks.size()) * (static_cast<double>(intervals.size()) - 1.0);
    for (int round = 0; round < learningRounds; ++round) {
        double squares = 0.0;
        for (const PointTrack& track : tracks) {
            squares += smoothed(track, intervals, step).squaredSteps;
        }
        step = std::max(minStepMm2, squares / steps);
    }
    return step;
}

/// Returns the result with its points moved to new positions, given in patient axes at the rigid pose.
std::shared_ptr<const DeformableResult> withPositions(const TimedDeformation& deformation, const VesselTree& tree,
                                                      const std::vector<SmoothTrack>& tracks, std::size_t time)
{
    auto result = std::make_shared<DeformableResult>(*deformation.deformed);
    const RigidTransform deformedFromRigid = result->cameraFromPatient.inverse() * deformation.rigidCameraFromPatient;
    std::size_t next = 0;
    for (const VesselBranch& branch : tree.branches) {
        const auto motion = std::ranges::find(result->branches, branch.id, &BranchMotion::branchId);
        for (std::size_t i = 0; i < branch.pointsInPatient.size(); ++i) {
            motion->displacementMm[i] = deformedFromRigid * tracks[next++].positions[time] - branch.pointsInPatient[i];
        }
        roundMotion(*motion);
    }
    return result;
}

}   // namespace

std::vector<TimedDeformation> smoothOverTime(const VesselTree& tree, const std::vector<TimedDeformation>& deformations)
{
    const bool areUsable = std::ranges::all_of(deformations, [&tree](const TimedDeformation& each) {
        return each.deformed && isCompatible(tree, *each.deformed);
    });
    if (deformations.size() < 3 || !areUsable || tree.pointCount() == 0) {
        return deformations;
    }
    const std::vector<PointTrack> tracks = tracksOf(deformations, tree);
    const std::vector<double> intervals = frameIntervals(deformations);
    const double step = estimateStepVariance(tracks, intervals);
    std::vector<SmoothTrack> smooth;
    for (const PointTrack& track : tracks) {
        smooth.push_back(smoothed(track, intervals, step));
    }
    std::vector<TimedDeformation> result = deformations;
    for (std::size_t t = 0; t < deformations.size(); ++t) {
        result[t].deformed = withPositions(deformations[t], tree, smooth, t);
    }
    return result;
}

}   // namespace angiopose::core
