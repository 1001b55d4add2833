#include "app/cli/track_case.h"

#include "app/cli/console.h"
#include "core/workflow/track_frames.h"

#include <utility>

namespace angiopose::app {

core::Status trackForCommand(core::Case& session)
{
    core::View& shown = session.shown();
    const auto known = static_cast<int>(core::framesOf(shown.followed).size());
    if (shown.angiogram && known == shown.angiogram->frameCount()) {
        return core::Done{};
    }
    ProgressLine progress("following");
    auto frames = core::trackFrames(session, progress.observer());
    if (!frames) {
        return frames.error();
    }
    shown.followed = core::makeTrackedRun(shown.frame, std::move(frames).value());
    return core::Done{};
}

}   // namespace angiopose::app
