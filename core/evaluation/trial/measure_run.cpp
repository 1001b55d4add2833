#include "core/evaluation/trial/measure_run.h"

#include <algorithm>

namespace angiopose::core {
namespace {

constexpr double grossPx = 5.0;

void measureProjection(const Truth& truth, const PosePair& poses, RunRecord& record)
{
    const ProjectionError error = projectionError(truth.tree, truth.camera, poses);
    record.meanPx = error.meanPx;
    record.rmsPx = error.rmsPx;
    record.medianPx = error.medianPx;
    record.p75Px = error.p75Px;
    record.p95Px = error.p95Px;
    record.meanMm = error.meanMm;
    const std::vector<double> distances = projectionDistancesPx(truth.tree, truth.camera, poses);
    const auto above = std::count_if(distances.begin(), distances.end(), [](double d) { return !(d <= grossPx); });
    record.shareAbove5Px = static_cast<double>(above) / static_cast<double>(distances.size());
}

}   // namespace

void measureStart(const Truth& truth, const RigidTransform& start, RunRecord& record)
{
    const PosePair poses{start, truth.cameraFromPatient};
    record.startMeanPx = projectionError(truth.tree, truth.camera, poses).meanPx;
    record.startMtreMm = targetError(truth.targetsInPatient, poses).mtreMm;
    record.startAngleDeg = poseError(centroidInPatient(truth.tree), poses).angleDeg;
}

void measurePose(const Truth& truth, const RigidTransform& found, RunRecord& record)
{
    const PosePair poses{found, truth.cameraFromPatient};
    measureProjection(truth, poses, record);
    const TargetError target = targetError(truth.targetsInPatient, poses);
    record.mtreMm = target.mtreMm;
    record.mtreInPlaneMm = target.mtreInPlaneMm;
    record.mrpdMm = target.mrpdMm;
    const PoseError pose = poseError(centroidInPatient(truth.tree), poses);
    record.angleDeg = pose.angleDeg;
    record.outOfPlaneDeg = pose.outOfPlaneDeg;
    record.inPlaneDeg = pose.inPlaneDeg;
    record.seedDistanceMm = pose.seedDistanceMm;
    record.centroidInPlaneMm = pose.centroidInPlaneMm;
    record.centroidDepthMm = pose.centroidDepthMm;
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
