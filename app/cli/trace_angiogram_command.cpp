#include "app/cli/commands.h"
#include "core/tracing/trace_angiogram.h"
#include "io/angiogram_file.h"
#include "io/centerline2d_file.h"
#include "io/image_file.h"

#include <cstdio>

namespace app {

int runTraceAngiogram(const TraceAngiogramArguments& arguments)
{
    const auto angiogram = io::readAngiogram(arguments.imagePath);
    if (!angiogram) {
        return failInput(angiogram.error().message);
    }
    printWarnings(angiogram.value().warnings);
    const int frame = arguments.frame.value_or(angiogram.value().suggestedFrame);
    if (frame < 0 || frame >= angiogram.value().frameCount()) {
        return failInput(arguments.imagePath + ": frame " + std::to_string(frame) +
                         " does not exist. It has frames 0 to " + std::to_string(angiogram.value().frameCount() - 1) +
                         ".");
    }
    core::TraceOptions options;
    options.sensitivity = arguments.sensitivity;
    const auto trace = core::traceAngiogram(angiogram.value().frames[static_cast<std::size_t>(frame)],
                                            angiogram.value().polarity, options);
    if (!trace) {
        return failInput(arguments.imagePath + ": " + trace.error().message);
    }
    if (const auto status = io::writeCenterline2d(trace.value().centerline, arguments.outputPath); !status) {
        return failInput(status.error().message);
    }
    if (!arguments.maskPath.empty()) {
        if (const auto status = io::writePng(trace.value().vesselMask, arguments.maskPath); !status) {
            return failInput(status.error().message);
        }
    }
    std::printf("frame %d: %zu curves, %zu points\n", frame, trace.value().centerline.curves.size(),
                trace.value().centerline.pointCount());
    return exitDone;
}

}   // namespace app
