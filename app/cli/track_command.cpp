#include "app/cli/case_input.h"
#include "app/cli/commands.h"
#include "app/cli/register_case.h"
#include "app/messages/messages.h"
#include "app/texts/number_text.h"
#include "core/registration/deformable/deformed_tree.h"
#include "core/workflow/track_frames.h"
#include "io/pose_table.h"
#include "io/vessel_tree_file.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

namespace angiopose::app {
namespace {

void printFrames(const std::vector<core::TrackedRunFrame>& frames)
{
    for (const core::TrackedRunFrame& frame : frames) {
        const char* verdict = frame.problem                  ? "nothing traced"
                              : !frame.tracked.isTrustworthy ? "not explained"
                              : frame.tracked.isFromSearch   ? "found again"
                                                             : "followed";
        std::printf("frame %-6d agreement %s  %s%s\n", frame.frame + 1, fixedText(frame.tracked.score, 2).c_str(),
                    verdict,
                    frame.deformed && !frame.deformationSourceFrame
                        ? (", deformed by up to " + fixedText(frame.deformed->largestMotionMm, 1) + " mm").c_str()
                        : "");
    }
}

void printPeriod(const char* whose, const std::optional<core::PeriodicMotion>& motion)
{
    if (motion) {
        std::printf("%s every %s s, %s mm peak to peak\n", whose, fixedText(motion->periodS, 2).c_str(),
                    fixedText(2.0 * motion->amplitudeMm, 1).c_str());
    }
}

/// Writes the deformed vessels of each frame in patient coordinates, at the pose of that frame.
core::Status writeDeformedTrees(const core::Case& session, const std::vector<core::TrackedRunFrame>& frames,
                                const std::string& folder)
{
    std::error_code failure;
    std::filesystem::create_directories(folder, failure);
    if (failure) {
        return core::Error(messages::folderNotMade(folder, failure.message()));
    }
    for (const core::TrackedRunFrame& frame : frames) {
        if (!frame.deformed || frame.deformationSourceFrame) {
            continue;
        }
        const core::VesselTree deformed =
            core::deformedTreeAt(*session.vessels.tree, *frame.deformed, frame.tracked.cameraFromPatient);
        const std::string path =
            (std::filesystem::path(folder) / ("frame" + std::to_string(frame.frame) + ".vtp")).string();
        if (auto written = io::writeVesselTree(deformed, path); !written) {
            return written;
        }
    }
    return core::Done{};
}

}   // namespace

int runTrack(const TrackArguments& arguments)
{
    auto loaded = loadCaseForCommand(arguments.casePath, std::nullopt);
    if (!loaded) {
        return reportInputError(loaded.error());
    }
    core::Case session = std::move(loaded).value();
    if (!arguments.keepPose) {
        auto registered = registerForCommand(std::move(session), "registering");
        if (!registered) {
            return reportInputError(registered.error().about(arguments.casePath));
        }
        session = std::move(registered).value().session;
    }
    if (const auto followed = trackForCommand(session); !followed) {
        return reportInputError(followed.error().about(arguments.casePath));
    }
    const std::vector<core::TrackedRunFrame>& frames = core::framesOf(session.shown().followed);
    if (const auto status = io::writePoseTable(frames, arguments.outputPath); !status) {
        return reportInputError(status.error());
    }
    if (!arguments.deformedFolder.empty()) {
        if (const auto status = writeDeformedTrees(session, frames, arguments.deformedFolder); !status) {
            return reportInputError(status.error());
        }
    }
    printFrames(frames);
    const core::RunPeriods periods = core::periodsOf(session, frames);
    printPeriod("breath", periods.breathMotion);
    printPeriod("heartbeat", periods.heartMotion);
    if (isInterrupted()) {
        return exitInterrupted;
    }
    const bool areAll = std::ranges::all_of(frames, [](const auto& frame) { return frame.tracked.isTrustworthy; });
    return areAll ? exitSuccess : exitUnreliable;
}

}   // namespace angiopose::app
