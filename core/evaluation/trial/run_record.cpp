#include "core/evaluation/trial/run_record.h"

#include <algorithm>
#include <array>

namespace angiopose::core {
namespace {

constexpr double grossPx = 5.0;

/// Returns the points of the tree found if the true deformation is known; otherwise those of the rigid tree.
CorrespondingPoints treePoints(const GroundTruth& truth, const VesselTree& found, const PosePair& poses)
{
    return truth.deformedTree ? correspondingPoints(found, *truth.deformedTree, poses)
                              : correspondingPoints(truth.tree, poses);
}

double depthMm(const GroundTruth& truth)
{
    return (truth.cameraFromPatient * centroidInPatient(truth.tree)).z();
}

TargetError targetErrorOf(const GroundTruth& truth, const CorrespondingPoints& points, const PosePair& poses)
{
    return truth.deformedTree ? targetError(points) : targetError(truth.targetsInPatient, poses);
}

void recordProjectionErrors(const GroundTruth& truth, const CorrespondingPoints& points, RunRecord& record)
{
    const ProjectionError error = projectionError(truth.camera, points, depthMm(truth));
    record.meanPx = error.meanPx;
    record.rmsPx = error.rmsPx;
    record.medianPx = error.medianPx;
    record.p75Px = error.p75Px;
    record.p95Px = error.p95Px;
    record.meanMm = error.meanMm;
    const std::vector<double> distances = projectionDistancesPx(truth.camera, points);
    const auto above = std::count_if(distances.begin(), distances.end(), [](double d) { return !(d <= grossPx); });
    record.fractionAbove5Px = static_cast<double>(above) / static_cast<double>(distances.size());
}

void recordPoseErrors(const PoseError& pose, RunRecord& record)
{
    record.angleDeg = pose.angleDeg;
    record.outOfPlaneDeg = pose.outOfPlaneDeg;
    record.inPlaneDeg = pose.inPlaneDeg;
    record.seedDistanceMm = pose.seedDistanceMm;
    record.centroidInPlaneMm = pose.centroidInPlaneMm;
    record.centroidDepthMm = pose.centroidDepthMm;
}

}   // namespace

std::span<const RunField> runFields()
{
    using R = RunRecord;
    static constexpr std::array fields{
        RunField{"start_mean_px", &R::startMeanPx},
        RunField{"start_mtre_mm", &R::startMtreMm},
        RunField{"start_angle_deg", &R::startAngleDeg},
        RunField{"has_result", &R::hasResult},
        RunField{"trustworthy", &R::trustworthy},
        RunField{"iterations", &R::iterations},
        RunField{"closest_median_px", &R::closestMedianPx},
        RunField{"closest_mean_px", &R::closestMeanPx},
        RunField{"reverse_mean_px", &R::reverseMeanPx},
        RunField{"coverage", &R::coverage},
        RunField{"mean_px", &R::meanPx},
        RunField{"rms_px", &R::rmsPx},
        RunField{"median_px", &R::medianPx},
        RunField{"p75_px", &R::p75Px},
        RunField{"p95_px", &R::p95Px},
        RunField{"mean_mm", &R::meanMm},
        RunField{"share_above_5_px", &R::fractionAbove5Px},
        RunField{"mtre_mm", &R::mtreMm},
        RunField{"mtre_in_plane_mm", &R::mtreInPlaneMm},
        RunField{"mrpd_mm", &R::mrpdMm},
        RunField{"angle_deg", &R::angleDeg},
        RunField{"out_of_plane_deg", &R::outOfPlaneDeg},
        RunField{"in_plane_deg", &R::inPlaneDeg},
        RunField{"seed_distance_mm", &R::seedDistanceMm},
        RunField{"centroid_in_plane_mm", &R::centroidInPlaneMm},
        RunField{"centroid_depth_mm", &R::centroidDepthMm},
        RunField{"nees", &R::nees},
        RunField{"bound_rms_px", &R::boundRmsPx},
        RunField{"trace_ms", &R::traceMs, true},
        RunField{"target_ms", &R::targetMs, true},
        RunField{"search_ms", &R::searchMs, true},
        RunField{"solve_ms", &R::solveMs, true},
        RunField{"total_ms", &R::totalMs, true},
        RunField{"processor_ms", &R::processorMs, true},
    };
    return fields;
}

void measureInitialPose(const GroundTruth& truth, const RigidTransform& start, RunRecord& record)
{
    const PosePair poses{start, truth.cameraFromPatient};
    const CorrespondingPoints points = treePoints(truth, truth.tree, poses);
    record.startMeanPx = projectionError(truth.camera, points, depthMm(truth)).meanPx;
    record.startMtreMm = targetErrorOf(truth, points, poses).mtreMm;
    record.startAngleDeg = poseError(centroidInPatient(truth.tree), poses).angleDeg;
}

void measurePose(const GroundTruth& truth, const RigidTransform& found, RunRecord& record)
{
    measureDeformed(truth, found, truth.tree, record);
}

void measureDeformed(const GroundTruth& truth, const RigidTransform& found, const VesselTree& deformed,
                     RunRecord& record)
{
    const PosePair poses{found, truth.cameraFromPatient};
    const CorrespondingPoints points = treePoints(truth, deformed, poses);
    recordProjectionErrors(truth, points, record);
    const TargetError target = targetErrorOf(truth, points, poses);
    record.mtreMm = target.mtreMm;
    record.mtreInPlaneMm = target.mtreInPlaneMm;
    record.mrpdMm = target.mrpdMm;
    recordPoseErrors(poseError(centroidInPatient(truth.tree), poses), record);
}

void measureCovariance(const GroundTruth& truth, const RegistrationResult& result, RunRecord& record)
{
    const PosePair poses{result.cameraFromPatient, truth.cameraFromPatient};
    record.nees =
        normalizedErrorSquared(errorAboutCentroid(centroidInPatient(truth.tree), poses), result.uncertainty.covariance);
}

void recordResult(const RegistrationResult& result, RunRecord& record)
{
    record.hasResult = 1.0;
    record.trustworthy = result.trustworthy ? 1.0 : 0.0;
    record.iterations = result.iterations;
    record.closestMedianPx = result.metrics.medianPx;
    record.closestMeanPx = result.metrics.meanPx;
    record.reverseMeanPx = result.metrics.reverseMeanPx;
    record.coverage = result.metrics.coverage;
    record.targetMs = result.time.targetMs;
    record.searchMs = result.time.searchMs;
    record.solveMs = result.time.solveMs;
    record.totalMs = result.time.totalMs;
}

}   // namespace angiopose::core
