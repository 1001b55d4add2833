#include "core/evaluation/trial/run_trial.h"

#include "core/evaluation/trial/cramer_rao_bound.h"
#include "core/evaluation/trial/measure_run.h"
#include "core/support/stopwatch.h"

namespace angiopose::core {

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
    const Truth truth{*trial.tree, trial.input.camera, trial.trueCameraFromPatient, targetsOf(*trial.tree)};
    measureStart(truth, trial.input.initialCameraFromPatient, record);
    if (trial.hasRightAnswer) {
        measurePose(truth, result ? result.value().cameraFromPatient : trial.input.initialCameraFromPatient, record);
    }
    if (trial.errorBound) {
        record.boundRmsPx =
            rmsProjectionPx(*trial.tree, trial.input.camera, trial.trueCameraFromPatient, *trial.errorBound);
    }
    if (result) {
        noteResult(result.value(), record);
        if (trial.hasRightAnswer) {
            measureCovariance(truth, result.value(), record);
        }
        for (const IterationReport& report : result.value().history) {
            if (keepHistory == KeepHistory::Yes) {
                record.history.push_back(
                    projectionError(truth.tree, truth.camera, {report.cameraFromPatient, truth.cameraFromPatient})
                        .meanPx);
            }
        }
    }
    return record;
}

}   // namespace angiopose::core