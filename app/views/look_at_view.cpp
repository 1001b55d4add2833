#include "app/views/look_at_view.h"

#include "app/texts/overlay_picture.h"
#include "core/case/case_views.h"
#include "core/case/registration_input.h"

#include <algorithm>

namespace angiopose::app {
namespace {

bool isSameTarget(const ViewSight& a, const ViewSight& b)
{
    return a.angiogram == b.angiogram && a.frame == b.frame && a.givenTarget == b.givenTarget &&
           a.traceOptions == b.traceOptions;
}

core::Status judge(ViewLook& look, const core::Case& showing)
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
    const auto judged = core::evaluatePose(input.value(), showing.shown().cameraFromPatient);
    if (!judged) {
        return judged.error();
    }
    look.metrics = judged.value().metrics;
    return core::Done{};
}

void draw(ViewLook& look, const core::Case& showing, int widthPx)
{
    if (auto picture = drawThumbnail(showing, widthPx)) {
        look.picture = std::move(picture).value();
    } else {
        look.problem = picture.error().message;
    }
}

void lookAt(ViewLook& look, const core::Case& showing, int widthPx)
{
    draw(look, showing, widthPx);
    if (const auto judged = judge(look, showing); !judged) {
        look.problem = judged.error().message;
    }
}

}   // namespace

ViewSight sightOf(const core::View& view)
{
    const auto camera = core::cameraOf(view);
    return {view.angiogram,
            view.frame,
            core::givenTargetOf(view),
            core::traceOptionsOf(view),
            camera ? std::optional(camera.value()) : std::nullopt,
            view.cameraFromPatient.matrix()};
}

std::shared_ptr<const core::Centerline2d> knownTarget(const std::vector<ViewLook>& known, const ViewSight& sight)
{
    const auto found = std::ranges::find_if(
        known, [&sight](const ViewLook& look) { return look.target && isSameTarget(look.of, sight); });
    return found == known.end() ? nullptr : found->target;
}

std::vector<ViewLook> lookAtViews(const core::Case& session,
                                  const std::shared_ptr<const core::Centerline2d>& shownTarget,
                                  const std::vector<ViewLook>& known, int widthPx)
{
    std::vector<ViewLook> looks;
    for (std::size_t place = 0; place < session.views.size(); ++place) {
        ViewLook& look = looks.emplace_back();
        look.of = sightOf(session.views[place]);
        const bool isShown = place == session.shownView;
        if (isShown || look.of.angiogram) {
            look.target = isShown ? shownTarget : knownTarget(known, look.of);
            lookAt(look, core::showingView(session, place), widthPx);
        }
    }
    return looks;
}

}   // namespace angiopose::app
