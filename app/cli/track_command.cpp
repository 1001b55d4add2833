#include "app/cli/case_input.h"
#include "app/cli/commands.h"
#include "app/cli/register_case.h"
#include "app/texts/number_text.h"
#include "core/workflow/follow_frames.h"
#include "io/pose_table.h"

#include <algorithm>
#include <cstdio>

namespace angiopose::app {
namespace {

core::Result<std::vector<core::FollowedFrame>> followWithProgress(const core::Case& theCase)
{
    ProgressLine progress("following");
    return core::followFrames(theCase, progress.observer());
}

void printFrames(const std::vector<core::FollowedFrame>& frames)
{
    for (const core::FollowedFrame& frame : frames) {
        const char* verdict = frame.problem                  ? "nothing traced"
                              : !frame.tracked.isTrustworthy ? "not explained"
                              : frame.tracked.searched       ? "found again"
                                                             : "followed";
        std::printf("frame %-6d agreement %s  %s\n", frame.frame, fixedText(frame.tracked.score, 2).c_str(), verdict);
    }
}

}   // namespace

int runTrack(const TrackArguments& arguments)
{
    auto loaded = loadCaseForCommand(arguments.casePath, std::nullopt);
    if (!loaded) {
        return failInput(loaded.error());
    }
    core::Case theCase = std::move(loaded).value();
    if (!arguments.keepPose) {
        auto registered = registerForCommand(std::move(theCase), "registering");
        if (!registered) {
            return failInput(registered.error().about(arguments.casePath));
        }
        theCase = std::move(registered).value().theCase;
    }
    const auto frames = followWithProgress(theCase);
    if (!frames) {
        return failInput(frames.error().about(arguments.casePath));
    }
    if (const auto status = io::writePoseTable(frames.value(), arguments.outputPath); !status) {
        return failInput(status.error());
    }
    printFrames(frames.value());
    if (isInterrupted()) {
        return exitStopped;
    }
    const bool areAll =
        std::ranges::all_of(frames.value(), [](const auto& frame) { return frame.tracked.isTrustworthy; });
    return areAll ? exitDone : exitNotTrustworthy;
}

}   // namespace angiopose::app