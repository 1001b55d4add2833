#include "app/views/view_summary.h"

#include "app/texts/overlay_image.h"
#include "core/case/case_views.h"
#include "core/case/registration_input.h"

#include <algorithm>

namespace angiopose::app {
namespace {

bool isSameTarget(const ViewKey& a, const ViewKey& b)
{
    return a.angiogram == b.angiogram && a.frame == b.frame && a.givenTarget == b.givenTarget &&
           a.traceOptions == b.traceOptions;
}

core::Status judge(ViewSummary& summary, const core::Case& showing)
{
    if (!summary.target) {
        auto traced = core::targetOf(showing.shown());
        if (!traced) {
            return traced.error();
        }
        summary.target = std::make_shared<const core::Centerline2d>(std::move(traced).value());
    }
    const auto input = core::makeRegistrationInput(showing, *summary.target);
    if (!input) {
        return input.error();
    }
    const auto evaluated = core::evaluatePose(input.value(), showing.shown().cameraFromPatient);
    if (!evaluated) {
        return evaluated.error();
    }
    summary.metrics = evaluated.value().metrics;
    return core::Done{};
}

void draw(ViewSummary& summary, const core::Case& showing, int widthPx)
{
    if (auto picture = drawThumbnail(showing, widthPx)) {
        summary.picture = std::move(picture).value();
    } else {
        summary.problem = picture.error().message;
    }
}

void summarize(ViewSummary& summary, const core::Case& showing, int widthPx)
{
    draw(summary, showing, widthPx);
    if (const auto evaluated = judge(summary, showing); !evaluated) {
        summary.problem = evaluated.error().message;
    }
}

}   // namespace

ViewKey viewKey(const core::View& view)
{
    const auto camera = core::cameraOf(view);
    return {view.angiogram,
            view.frame,
            core::givenTargetOf(view),
            core::traceOptionsOf(view),
            camera ? std::optional(camera.value()) : std::nullopt,
            view.cameraFromPatient.matrix()};
}

std::shared_ptr<const core::Centerline2d> cachedTarget(const std::vector<ViewSummary>& known,
                                                       const ViewKey& requestedKey)
{
    const auto found = std::ranges::find_if(known, [&requestedKey](const ViewSummary& summary) {
        return summary.target && isSameTarget(summary.key, requestedKey);
    });
    return found == known.end() ? nullptr : found->target;
}

std::vector<ViewSummary> summarizeViews(const core::Case& session,
                                        const std::shared_ptr<const core::Centerline2d>& shownTarget,
                                        const std::vector<ViewSummary>& known, int widthPx)
{
    std::vector<ViewSummary> summaries;
    for (std::size_t viewIndex = 0; viewIndex < session.views.size(); ++viewIndex) {
        ViewSummary& summary = summaries.emplace_back();
        summary.key = viewKey(session.views[viewIndex]);
        const bool isShown = viewIndex == session.shownView;
        if (isShown || summary.key.angiogram) {
            summary.target = isShown ? shownTarget : cachedTarget(known, summary.key);
            summarize(summary, core::withShownView(session, viewIndex), widthPx);
        }
    }
    return summaries;
}

}   // namespace angiopose::app
