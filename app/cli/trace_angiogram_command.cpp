#include "app/cli/commands.h"
#include "app/messages/says.h"
#include "core/case/devices_apart.h"
#include "core/tracing/angiogram/frame/steady_frame.h"
#include "core/tracing/angiogram/run/subtract_run.h"
#include "core/tracing/angiogram/trace_angiogram.h"
#include "io/angiogram_file.h"
#include "io/centerline2d_file.h"
#include "io/image_file.h"
#include "io/subtraction_file.h"

#include <cstdio>

namespace angiopose::app {
namespace {

using core::Angiogram;

std::string joined(const std::vector<int>& numbers)
{
    std::string text;
    for (const int number : numbers) {
        text += (text.empty() ? "" : ", ") + std::to_string(number);
    }
    return text;
}

/// Replaces the frames by subtracted ones where the arguments ask for it.
core::Status subtractIfAsked(const TraceAngiogramArguments& arguments, Angiogram& angiogram)
{
    if (!arguments.subtract && arguments.maskFrames.empty() && arguments.maskShiftPx.empty()) {
        return core::Done{};
    }
    auto plan = io::readSubtractionPlan(arguments.imagePath);
    if (!plan) {
        return plan.error();
    }
    core::SubtractionPlan chosen = std::move(plan).value();
    if (!arguments.maskFrames.empty()) {
        chosen.maskFrames = arguments.maskFrames;
    }
    if (arguments.maskShiftPx.size() == 2) {
        chosen.maskShiftPx = Eigen::Vector2d(arguments.maskShiftPx[0], arguments.maskShiftPx[1]);
    }
    auto run = core::subtractRun(angiogram.frames, angiogram.polarity, chosen);
    if (!run) {
        return run.error().about(arguments.imagePath);
    }
    std::printf("subtracted: mean of frames %s\n", joined(run.value().maskFrames).c_str());
    angiogram.frames = std::move(run).value().frames;
    return core::Done{};
}

/// What was traced, and what to call it.
struct NamedTrace {
    core::AngiogramTrace trace;
    std::string name;
};

/// The vessels of the frame that the arguments ask for, or of all frames together.
core::Result<NamedTrace> traceAsked(const TraceAngiogramArguments& arguments, const Angiogram& angiogram)
{
    core::TraceOptions options;
    options.sensitivity = arguments.sensitivity;
    const int frame = arguments.frame.value_or(angiogram.suggestedFrame);
    if (!arguments.composite && (frame < 0 || frame >= angiogram.frameCount())) {
        return core::Error(says::frameBeyondRun(frame, angiogram.frameCount() - 1).about(arguments.imagePath));
    }
    auto trace = arguments.composite
                     ? core::traceAngiogram(core::opacifiedComposite(angiogram.frames, angiogram.polarity),
                                            angiogram.polarity, options)
                     : core::traceFrame(angiogram, frame, options);
    if (!trace) {
        return trace.error().about(arguments.imagePath);
    }
    return NamedTrace{std::move(trace).value(), arguments.composite ? "all frames" : "frame " + std::to_string(frame)};
}

core::Status writeTrace(const core::AngiogramTrace& trace, const TraceAngiogramArguments& arguments)
{
    const core::CurvesApart curves = arguments.apartPath.empty()
                                         ? core::CurvesApart{trace.centerline, {}}
                                         : core::takenApart(trace.centerline, trace.suspectCurves);
    if (const auto status = io::writeCenterline2d(curves.vessels, arguments.outputPath); !status) {
        return status.error();
    }
    if (!arguments.apartPath.empty()) {
        if (const auto status = io::writeCenterline2d(curves.devices, arguments.apartPath); !status) {
            return status.error();
        }
    }
    return arguments.maskPath.empty() ? core::Status(core::Done{}) : io::writePng(trace.vesselMask, arguments.maskPath);
}

}   // namespace

int runTraceAngiogram(const TraceAngiogramArguments& arguments)
{
    auto read = io::readAngiogram(arguments.imagePath);
    if (!read) {
        return failInput(read.error());
    }
    Angiogram angiogram = std::move(read).value();
    printWarnings(angiogram.warnings);
    if (const auto status = subtractIfAsked(arguments, angiogram); !status) {
        return failInput(status.error());
    }
    const auto traced = traceAsked(arguments, angiogram);
    if (!traced) {
        return failInput(traced.error());
    }
    const core::AngiogramTrace& trace = traced.value().trace;
    printWarnings(trace.warnings);
    if (const auto status = writeTrace(trace, arguments); !status) {
        return failInput(status.error());
    }
    const std::size_t count = trace.centerline.curves.size();
    std::printf("%s: %zu %s, %zu points\n", traced.value().name.c_str(), count, count == 1 ? "curve" : "curves",
                trace.centerline.pointCount());
    if (!trace.suspectCurves.empty()) {
        const std::string where = arguments.apartPath.empty() ? "" : ", apart in " + arguments.apartPath;
        std::printf("may be catheter, wire or edge of a bone: curves %s%s\n", joined(trace.suspectCurves).c_str(),
                    where.c_str());
    }
    return exitDone;
}

}   // namespace angiopose::app