#include "app/cli/register_case.h"

#include "app/cli/console.h"
#include "app/messages/messages.h"
#include "core/registration/methods/method_info.h"
#include "core/registration/options/option_text.h"
#include "core/support/utc_time.h"
#include "core/workflow/track_frames.h"

#include <cstdlib>
#include <utility>

namespace angiopose::app {
namespace {

core::Result<core::PoseLocks> locksFrom(const std::vector<std::string>& ids)
{
    core::PoseLocks locks{};
    for (const std::string& id : ids) {
        const auto axis = core::parsePoseAxis(id);
        if (axis) {
            locks[static_cast<std::size_t>(*axis)] = true;
        } else if (id != "none") {
            return core::Error(messages::noSuchFreedom(id, core::poseAxisIds()));
        }
    }
    return locks;
}

core::RegistrationPlan signedPlan(core::RegistrationPlan plan)
{
    const char* user = std::getenv("USER");
    plan.author = user ? user : "";
    plan.time = core::utcNow();
    return plan;
}

}   // namespace

core::Status applyArguments(core::Case& session, const RegisterArguments& arguments)
{
    if (!arguments.method.empty()) {
        session.options.method = arguments.method;
    }
    for (const std::string& assignment : arguments.options) {
        if (const auto status = core::setOption(session.options, assignment); !status) {
            return status.error();
        }
    }
    if (!arguments.locks.empty()) {
        const auto locks = locksFrom(arguments.locks);
        if (!locks) {
            return locks.error();
        }
        session.options.locks = locks.value();
    }
    if (const auto problem = core::findProblem(session.options)) {
        return core::Error(*problem);
    }
    if (!arguments.auxiliaryBranchIds.empty()) {
        session.vessels.auxiliaryBranchIds = arguments.auxiliaryBranchIds;
    }
    if (!arguments.excludedBranchIds.empty()) {
        session.vessels.excludedBranchIds = arguments.excludedBranchIds;
    }
    return core::Done{};
}

core::Result<core::RegisteredCase> registerForCommand(core::Case session, const std::string& label,
                                                      core::RegistrationPlan plan)
{
    ProgressLine progress(label);
    return core::registerCase(std::move(session), signedPlan(std::move(plan)), progress.observer());
}

core::Result<core::RegisteredCase> registerWithoutProgress(core::Case session, core::RegistrationPlan plan)
{
    return core::registerCase(std::move(session), signedPlan(std::move(plan)), [](const core::WorkReport&) {
        return isInterrupted() ? core::ObserverDecision::Stop : core::ObserverDecision::Continue;
    });
}

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
