#include "app/cli/case_input.h"

#include "app/cli/console.h"
#include "app/messages/says.h"
#include "core/case/start_pose.h"
#include "io/opening/open_case_with.h"

namespace angiopose::app {

core::Result<core::Case> loadCaseForCommand(const std::string& path, std::optional<int> frame)
{
    core::Messages warnings;
    auto loaded = [&] {
        ProgressLine progress("reading");
        const io::CaseWish wish{{}, io::FullestFrame::NotNeeded};
        return io::openCaseWith(wish, path, warnings, [&progress](double fraction) {
            progress.show(fraction, "");
            return isInterrupted() ? core::Verdict::Stop : core::Verdict::Continue;
        });
    }();
    printWarnings(warnings);
    return loaded ? atFrame(std::move(loaded).value(), frame, path) : loaded;
}

core::Result<core::Case> atFrame(core::Case theCase, std::optional<int> frame, const std::string& path)
{
    if (!frame) {
        return theCase;
    }
    const int frameCount = theCase.shown().angiogram ? theCase.shown().angiogram->frameCount() : 0;
    if (*frame < 0 || *frame >= frameCount) {
        return core::Error(says::frameBeyondRun(*frame, frameCount - 1).about(path));
    }
    core::View& shown = theCase.shown();
    if (core::findFrame(shown.followed, *frame) && *frame != shown.frame) {
        shown = core::withFrame(std::move(shown), theCase.vessels, *frame);
    }
    shown.frame = *frame;
    return theCase;
}

}   // namespace angiopose::app