#include "app/cli/commands.h"
#include "app/messages/messages.h"
#include "core/case/separate_devices.h"
#include "core/tracing/angiogram/frame/denoise_frame.h"
#include "core/tracing/angiogram/run/subtract_run.h"
#include "core/tracing/angiogram/trace_angiogram.h"
#include "io/angiogram_file.h"
#include "io/centerline2d_file.h"
#include "io/image_file.h"
#include "io/subtraction_file.h"

#include <algorithm>
#include <cstdio>
#include <iterator>

namespace angiopose::app {
namespace {

using core::Angiogram;

std::string joined(const std::vector<int>& numbers, int first = 0)
{
    std::string text;
    for (const int number : numbers) {
        text += (text.empty() ? "" : ", ") + std::to_string(number + first);
    }
    return text;
}

/// Subtracts the mask from the frames if the arguments or the file request it.
core::Status subtractIfRequested(const TraceAngiogramArguments& arguments, Angiogram& angiogram)
{
    const auto header = io::readRunProcessing(arguments.imagePath);
    if (!header) {
        return header.error();
    }
    const bool isAsked = !arguments.maskFrames.empty() || !arguments.maskShiftPx.empty() ||
                         arguments.subtract.value_or(header.value().isSubtracted && angiogram.frameCount() > 1);
    if (!isAsked) {
        return core::Done{};
    }
    core::SubtractionPlan subtraction = header.value().plan;
    if (!arguments.maskFrames.empty()) {
        subtraction.interval.reset();
        subtraction.maskFrames.clear();
        std::ranges::transform(arguments.maskFrames, std::back_inserter(subtraction.maskFrames),
                               [](int number) { return std::max(number, 0) - 1; });
    }
    if (subtraction.maskFrames.empty() && !subtraction.interval) {
        subtraction.maskFrames = core::suggestMaskFrames(angiogram.frames, angiogram.polarity, angiogram.shutter);
    }
    if (arguments.maskShiftPx.size() == 2) {
        subtraction.maskShiftPx = Eigen::Vector2d(arguments.maskShiftPx[0], arguments.maskShiftPx[1]);
    }
    auto run = core::subtractRun(angiogram.frames, angiogram.polarity, subtraction);
    if (!run) {
        return run.error().about(arguments.imagePath);
    }
    std::printf("subtracted: mean of frames %s\n", joined(run.value().maskFrames, 1).c_str());
    angiogram.frames = std::move(run).value().frames;
    return core::Done{};
}

/// A trace with its display name.
struct NamedTrace {
    core::AngiogramTrace trace;
    std::string name;
};

/// Traces the requested frame, or the peak-opacification image of all frames.
core::Result<NamedTrace> traceRequestedFrame(const TraceAngiogramArguments& arguments, const Angiogram& angiogram)
{
    core::TraceOptions options;
    options.sensitivity = arguments.sensitivity;
    const int frame = arguments.frame.value_or(angiogram.suggestedFrame);
    if (!arguments.composite && (frame < 0 || frame >= angiogram.frameCount())) {
        return core::Error(messages::frameBeyondRun(frame + 1, angiogram.frameCount()).about(arguments.imagePath));
    }
    auto trace = arguments.composite
                     ? core::traceAngiogram(core::peakOpacificationImage(angiogram.frames, angiogram.polarity),
                                            angiogram.polarity, options, angiogram.shutter)
                     : core::traceFrame(angiogram, frame, options);
    if (!trace) {
        return trace.error().about(arguments.imagePath);
    }
    return NamedTrace{std::move(trace).value(), arguments.composite ? "all frames"
                                                                    : "frame " + std::to_string(frame + 1) + " of " +
                                                                          std::to_string(angiogram.frameCount())};
}

core::Status writeTrace(const core::AngiogramTrace& trace, const TraceAngiogramArguments& arguments)
{
    const core::SeparatedCurves curves = arguments.devicePath.empty()
                                             ? core::SeparatedCurves{trace.centerline, {}}
                                             : core::separateDevices(trace.centerline, trace.suspectCurves);
    if (const auto status = io::writeCenterline2d(curves.vessels, arguments.outputPath); !status) {
        return status.error();
    }
    if (!arguments.devicePath.empty()) {
        if (const auto status = io::writeCenterline2d(curves.devices, arguments.devicePath); !status) {
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
        return reportInputError(read.error());
    }
    Angiogram angiogram = std::move(read).value();
    printWarnings(angiogram.warnings);
    if (const auto status = subtractIfRequested(arguments, angiogram); !status) {
        return reportInputError(status.error());
    }
    const auto traced = traceRequestedFrame(arguments, angiogram);
    if (!traced) {
        return reportInputError(traced.error());
    }
    const core::AngiogramTrace& trace = traced.value().trace;
    printWarnings(trace.warnings);
    if (const auto status = writeTrace(trace, arguments); !status) {
        return reportInputError(status.error());
    }
    const std::size_t count = trace.centerline.curves.size();
    std::printf("%s: %zu %s, %zu points\n", traced.value().name.c_str(), count, count == 1 ? "curve" : "curves",
                trace.centerline.pointCount());
    if (!trace.suspectCurves.empty()) {
        const std::string where = arguments.devicePath.empty() ? "" : ", separately in " + arguments.devicePath;
        std::printf("possible catheter, guidewire or bone edge: curves %s%s\n", joined(trace.suspectCurves).c_str(),
                    where.c_str());
    }
    return exitSuccess;
}

}   // namespace angiopose::app
