#include "core/evaluation/trial/run_trial.h"

#include "core/evaluation/trial/cramer_rao_bound.h"
#include "core/evaluation/trial/projection_error.h"
#include "core/support/stopwatch.h"

#include <algorithm>

namespace angiopose::core {
namespace {

constexpr double grossPx = 5.0;

double meanDistancePx(const Trial& trial, const RigidTransform& pose)
{
    return projectionError(*trial.tree, trial.input.camera, {pose, trial.trueCameraFromPatient}).meanPx;
}

void measureStart(const Trial& trial, RunRecord& record)
{
    const PosePair poses{trial.input.initialCameraFromPatient, trial.trueCameraFromPatient};
    record.startMeanPx = meanDistancePx(trial, poses.estimate);
    record.startMtreMm = targetError(targetsOf(*trial.tree), poses).mtreMm;
    record.startAngleDeg = poseError(centroidInPatient(*trial.tree), poses).angleDeg;
}

void measureProjection(const Trial& trial, const PosePair& poses, RunRecord& record)
{
    const ProjectionError error = projectionError(*trial.tree, trial.input.camera, poses);
    record.meanPx = error.meanPx;
    record.rmsPx = error.rmsPx;
    record.medianPx = error.medianPx;
    record.p75Px = error.p75Px;
    record.p95Px = error.p95Px;
    record.meanMm = error.meanMm;
    const std::vector<double> distances = projectionDistancesPx(*trial.tree, trial.input.camera, poses);
    const auto above = std::count_if(distances.begin(), distances.end(), [](double d) { return !(d <= grossPx); });
    record.shareAbove5Px = static_cast<double>(above) / static_cast<double>(distances.size());
}

void measurePose(const Trial& trial, const PosePair& poses, RunRecord& record)
{
    const TargetError target = targetError(targetsOf(*trial.tree), poses);
    record.mtreMm = target.mtreMm;
    record.mtreInPlaneMm = target.mtreInPlaneMm;
    record.mrpdMm = target.mrpdMm;
    const PoseError pose = poseError(centroidInPatient(*trial.tree), poses);
    record.angleDeg = pose.angleDeg;
    record.outOfPlaneDeg = pose.outOfPlaneDeg;
    record.inPlaneDeg = pose.inPlaneDeg;
    record.seedDistanceMm = pose.seedDistanceMm;
    record.centroidInPlaneMm = pose.centroidInPlaneMm;
    record.centroidDepthMm = pose.centroidDepthMm;
}

void readResult(const Trial& trial, const RegistrationResult& result, RunRecord& record)
{
    record.hasResult = 1.0;
    record.trustworthy = result.trustworthy ? 1.0 : 0.0;
    record.iterations = result.iterations;
    record.closestMedianPx = result.metrics.medianPx;
    record.closestMeanPx = result.metrics.meanPx;
    record.reverseMeanPx = result.metrics.reverseMeanPx;
    record.coverage = result.metrics.coverage;
    if (trial.hasRightAnswer) {
        record.nees = normalizedErrorSquared(
            errorAboutCentroid(centroidInPatient(*trial.tree), {result.cameraFromPatient, trial.trueCameraFromPatient}),
            result.uncertainty.covariance);
    }
    record.targetMs = result.time.targetMs;
    record.searchMs = result.time.searchMs;
    record.solveMs = result.time.solveMs;
    record.totalMs = result.time.totalMs;
}

}   // namespace

std::optional<RunRecord> runTrial(const Trial& trial, const Contestant& contestant, KeepHistory keepHistory,
                                  const std::function<bool()>& isStopped)
{
    bool wasStopped = false;
    const ThreadStopwatch processor;
    const auto result =
        registerVessels(trial.input, optionsFor(contestant, trial.targetIsExact), [&](const IterationReport&) {
            wasStopped = wasStopped || isStopped();
            return wasStopped ? Verdict::Stop : Verdict::Continue;
        });
    if (wasStopped) {
        return std::nullopt;
    }
    RunRecord record;
    record.processorMs = processor.elapsedMs();
    record.traceMs = trial.traceMs.value_or(unknownMeasure);
    record.method = contestant.label;
    measureStart(trial, record);
    const PosePair poses{result ? result.value().cameraFromPatient : trial.input.initialCameraFromPatient,
                         trial.trueCameraFromPatient};
    if (trial.hasRightAnswer) {
        measureProjection(trial, poses, record);
        measurePose(trial, poses, record);
    }
    if (trial.errorBound) {
        record.boundRmsPx =
            rmsProjectionPx(*trial.tree, trial.input.camera, trial.trueCameraFromPatient, *trial.errorBound);
    }
    if (result) {
        readResult(trial, result.value(), record);
        for (const IterationReport& report : result.value().history) {
            if (keepHistory == KeepHistory::Yes) {
                record.history.push_back(meanDistancePx(trial, report.cameraFromPatient));
            }
        }
    }
    return record;
}

}   // namespace angiopose::core