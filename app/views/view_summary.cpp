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

core::Status judge(ViewSummary& look, const core::Case& showing)
{
    if (!look.target) {
        auto traced = core::targetOf(showing.shown());
        if (!traced) {
            return traced.error();
        }
        look.target = std::make_shared<const core::Centerline2d>(std::move(traced).value());
    }
    const auto input = core::registrationInputOf(showing, *look.target);
    if (!input) {
        return input.error();
    }
    const auto evaluated = core::evaluatePose(input.value(), showing.shown().cameraFromPatient);
    if (!evaluated) {
        return evaluated.error();
    }
    look.metrics = evaluated.value().metrics;
    return core::Done{};
}

void draw(ViewSummary& look, const core::Case& showing, int widthPx)
{
    if (auto picture = drawThumbnail(showing, widthPx)) {
        look.picture = std::move(picture).value();
    } else {
        look.problem = picture.error().message;
    }
}

void lookAt(ViewSummary& look, const core::Case& showing, int widthPx)
{
    draw(look, showing, widthPx);
    if (const auto evaluated = judge(look, showing); !evaluated) {
        look.problem = evaluated.error().message;
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

std::shared_ptr<const core::Centerline2d> cachedTarget(const std::vector<ViewSummary>& known, const ViewKey& sight)
{
    const auto found = std::ranges::find_if(
        known, [&sight](const ViewSummary& look) { return look.target && isSameTarget(look.of, sight); });
    return found == known.end() ? nullptr : found->target;
}

std::vector<ViewSummary> summarizeViews(const core::Case& session,
                                        const std::shared_ptr<const core::Centerline2d>& shownTarget,
                                        const std::vector<ViewSummary>& known, int widthPx)
{
    std::vector<ViewSummary> looks;
    for (std::size_t viewIndex = 0; viewIndex < session.views.size(); ++viewIndex) {
        ViewSummary& look = looks.emplace_back();
        look.of = viewKey(session.views[viewIndex]);
        const bool isShown = viewIndex == session.shownView;
        if (isShown || look.of.angiogram) {
            look.target = isShown ? shownTarget : cachedTarget(known, look.of);
            lookAt(look, core::withShownView(session, viewIndex), widthPx);
        }
    }
    return looks;
}

}   // namespace angiopose::app
