#include "core/evaluation/trial/measure_run.h"

#include <algorithm>

namespace angiopose::core {
namespace {

constexpr double grossPx = 5.0;

/// Of the tree that was found; where it is not known how bent vessels lay, of the rigid one.
PlacedPoints treePoints(const Truth& truth, const VesselTree& found, const PosePair& poses)
{
    return truth.bentTree ? placed(found, *truth.bentTree, poses) : placed(truth.tree, poses);
}

double depthMm(const Truth& truth)
{
    return (truth.cameraFromPatient * centroidInPatient(truth.tree)).z();
}

TargetError targetErrorOf(const Truth& truth, const PlacedPoints& points, const PosePair& poses)
{
    return truth.bentTree ? targetError(points) : targetError(truth.targetsInPatient, poses);
}

void noteProjection(const Truth& truth, const PlacedPoints& points, RunRecord& record)
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
    record.shareAbove5Px = static_cast<double>(above) / static_cast<double>(distances.size());
}

void notePose(const PoseError& pose, RunRecord& record)
{
    record.angleDeg = pose.angleDeg;
    record.outOfPlaneDeg = pose.outOfPlaneDeg;
    record.inPlaneDeg = pose.inPlaneDeg;
    record.seedDistanceMm = pose.seedDistanceMm;
    record.centroidInPlaneMm = pose.centroidInPlaneMm;
    record.centroidDepthMm = pose.centroidDepthMm;
}

}   // namespace

void measureStart(const Truth& truth, const RigidTransform& start, RunRecord& record)
{
    const PosePair poses{start, truth.cameraFromPatient};
    const PlacedPoints points = treePoints(truth, truth.tree, poses);
    record.startMeanPx = projectionError(truth.camera, points, depthMm(truth)).meanPx;
    record.startMtreMm = targetErrorOf(truth, points, poses).mtreMm;
    record.startAngleDeg = poseError(centroidInPatient(truth.tree), poses).angleDeg;
}

void measurePose(const Truth& truth, const RigidTransform& found, RunRecord& record)
{
    measureBent(truth, found, truth.tree, record);
}

void measureBent(const Truth& truth, const RigidTransform& found, const VesselTree& bent, RunRecord& record)
{
    const PosePair poses{found, truth.cameraFromPatient};
    const PlacedPoints points = treePoints(truth, bent, poses);
    noteProjection(truth, points, record);
    const TargetError target = targetErrorOf(truth, points, poses);
    record.mtreMm = target.mtreMm;
    record.mtreInPlaneMm = target.mtreInPlaneMm;
    record.mrpdMm = target.mrpdMm;
    notePose(poseError(centroidInPatient(truth.tree), poses), record);
}

void measureCovariance(const Truth& truth, const RegistrationResult& result, RunRecord& record)
{
    const PosePair poses{result.cameraFromPatient, truth.cameraFromPatient};
    record.nees =
        normalizedErrorSquared(errorAboutCentroid(centroidInPatient(truth.tree), poses), result.uncertainty.covariance);
}

void noteResult(const RegistrationResult& result, RunRecord& record)
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
