#include "app/cli/case_input.h"
#include "app/cli/commands.h"
#include "app/cli/register_case.h"
#include "app/messages/messages.h"
#include "app/texts/number_text.h"
#include "core/workflow/register_case.h"

#include <cstdio>

namespace angiopose::app {
namespace {

MoviePlan planOf(const MovieArguments& arguments, const core::Case& session)
{
    const core::Angiogram& run = *session.shown().angiogram;
    MoviePlan plan;
    plan.content = arguments.content;
    plan.frames = arguments.frames.empty() ? core::FrameRange{0, run.frameCount() - 1}
                                           : core::FrameRange{arguments.frames[0] - 1, arguments.frames[1] - 1};
    plan.order = arguments.isBackAndForth ? core::CineOrder::BackAndForth : core::CineOrder::Loop;
    const double usual = arguments.content == MovieContent::Run           ? framesPerSecondOf(run)
                         : arguments.content == MovieContent::Convergence ? convergenceFramesPerSecond
                                                                          : rotationFramesPerSecond;
    plan.framesPerSecond = (arguments.framesPerSecond > 0.0 ? arguments.framesPerSecond : usual) * arguments.speed;
    return plan;
}

/// Returns whether registration must run first. A convergence movie uses the stored registration if the case has one.
bool needsRun(const MovieArguments& arguments, const core::Case& session)
{
    const auto& result = session.shown().result;
    const bool isKnown = result && !result->history.empty();
    return arguments.isRegistered || (arguments.content == MovieContent::Convergence && !isKnown);
}

core::Result<core::Case> registered(core::Case session)
{
    auto found = registerForCommand(std::move(session), "registering");
    return found ? core::Result<core::Case>(std::move(found).value().session) : core::Result<core::Case>(found.error());
}

core::Status write(const core::Case& session, const MovieArguments& arguments, const MoviePlan& plan)
{
    OverlayImageOptions options;
    options.widthPx = arguments.widthPx;
    options.coloring = OverlayColoring::Branches;
    options.shape = arguments.isRigid ? VesselShape::Rigid : VesselShape::Deformed;
    options.depthCue = arguments.depthCue ? ui::DepthCue::NearBright : ui::DepthCue::None;
    ProgressLine progress("writing");
    return writeMovie(session, {}, options, plan, arguments.outputPath, [&progress](double fraction) {
        progress.show(fraction, "");
        return isInterrupted() ? core::ObserverDecision::Stop : core::ObserverDecision::Continue;
    });
}

}   // namespace

int runMovie(const MovieArguments& arguments)
{
    auto loaded = loadCaseForCommand(arguments.casePath, arguments.frame);
    if (loaded && !loaded.value().shown().angiogram) {
        loaded = core::Error(messages::overlayIncomplete().about(arguments.casePath));
    }
    if (loaded && needsRun(arguments, loaded.value())) {
        loaded = registered(std::move(loaded).value());
    }
    if (!loaded) {
        return reportInputError(loaded.error());
    }
    core::Case session = std::move(loaded).value();
    MoviePlan plan = planOf(arguments, session);
    if (arguments.isTracked && arguments.content == MovieContent::Run) {
        if (const auto followed = trackForCommand(session); !followed) {
            return reportInputError(followed.error().about(arguments.casePath));
        }
        plan.followed = core::framesOf(session.shown().followed);
    }
    if (const auto written = write(session, arguments, plan); !written) {
        return reportInputError(written.error());
    }
    const MovieLength length = movieLength(session, plan);
    std::printf("%s: %zu frames, %s s\n", arguments.outputPath.c_str(), length.pictures,
                fixedText(length.seconds, 2).c_str());
    return exitSuccess;
}

}   // namespace angiopose::app
