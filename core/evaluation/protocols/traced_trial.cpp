#include "core/evaluation/protocols/traced_trial.h"

#include "core/support/stopwatch.h"
#include "core/tracing/angiogram/trace_angiogram.h"

namespace angiopose::core {

Trial tracedTrial(const SimulatedCase& view)
{
    Trial trial;
    Stopwatch stopwatch;
    const auto traced = traceAngiogram(view.angiogram.frames.front(), view.angiogram.polarity);
    trial.traceMs = stopwatch.lapMs();
    if (traced) {
        trial.input.target = traced.value().centerline;
    }
    trial.input.image = std::make_shared<const ImageF>(view.angiogram.frames.front());
    trial.input.polarity = view.angiogram.polarity;
    trial.input.tree = view.tree;
    trial.input.camera = view.camera;
    trial.input.initialCameraFromPatient = view.initialCameraFromPatient;
    trial.tree = std::make_shared<const VesselTree>(view.tree);
    trial.trueCameraFromPatient = view.trueCameraFromPatient;
    return trial;
}

}   // namespace angiopose::core