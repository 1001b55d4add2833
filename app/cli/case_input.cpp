#include "app/cli/case_input.h"

#include "app/cli/console.h"
#include "app/messages/messages.h"
#include "core/case/initial_pose.h"
#include "io/opening/open_case_with_options.h"
#include "io/opening/open_result.h"

namespace angiopose::app {

core::Result<core::Case> loadCaseForCommand(const std::string& path, std::optional<int> frame)
{
    core::Messages warnings;
    auto loaded = [&] {
        ProgressLine progress("reading");
        const io::CaseLoadOptions request{{}, io::PeakFrameSearch::Skipped};
        return io::openCaseWithOptions(request, path, warnings, [&progress](double fraction) {
            progress.show(fraction, "");
            return isInterrupted() ? core::ObserverDecision::Stop : core::ObserverDecision::Continue;
        });
    }();
    printWarnings(warnings);
    return loaded ? selectFrame(std::move(loaded).value(), frame, path) : loaded;
}

core::Result<core::Case> loadResultForCommand(const ResultSource& from, ResultState stage, std::optional<int> frame)
{
    core::Messages warnings;
    const io::ResultLocation place{from.path, from.inputFolders};
    const auto observe = [](double) {
        return isInterrupted() ? core::ObserverDecision::Stop : core::ObserverDecision::Continue;
    };
    auto loaded = stage == ResultState::Unregistered ? io::openInputCase(place, warnings, observe)
                                                     : io::openResultCase(place, warnings, observe);
    printWarnings(warnings);
    return loaded ? selectFrame(std::move(loaded).value(), frame, from.path) : loaded;
}

core::Result<core::Case> loadPairForCommand(const InputPair& pair, std::optional<int> frame)
{
    core::Messages warnings;
    auto loaded = [&] {
        ProgressLine progress("reading");
        return openPair(pair, {}, warnings, [&progress](double fraction) {
            progress.show(fraction, "");
            return isInterrupted() ? core::ObserverDecision::Stop : core::ObserverDecision::Continue;
        });
    }();
    printWarnings(warnings);
    return loaded ? selectFrame(std::move(loaded).value(), frame, pair.angiogramPath) : loaded;
}

core::Result<core::Case> selectFrame(core::Case session, std::optional<int> frame, const std::string& path)
{
    if (!frame) {
        return session;
    }
    const int frameCount = session.shown().angiogram ? session.shown().angiogram->frameCount() : 0;
    if (*frame < 0 || *frame >= frameCount) {
        return core::Error(messages::frameBeyondRun(*frame + 1, frameCount).about(path));
    }
    core::View& shown = session.shown();
    if (core::findFrame(shown.followed, *frame) && *frame != shown.frame) {
        shown = core::withFrame(std::move(shown), *frame);
    }
    shown.frame = *frame;
    return session;
}

}   // namespace angiopose::app
