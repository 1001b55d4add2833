#include "app/views/look_at_view.h"

#include "app/texts/overlay_picture.h"
#include "core/case_views.h"

#include <algorithm>

namespace angiopose::app {
namespace {

std::shared_ptr<const core::Centerline2d> knownTarget(const std::vector<ViewLook>& known,
                                                      const std::shared_ptr<const core::RegistrationCase>& view)
{
    const auto found = std::ranges::find(known, view, &ViewLook::view);
    return found == known.end() ? nullptr : found->target;
}

core::Status judge(ViewLook& look, const core::RegistrationCase& view)
{
    if (!look.target) {
        auto traced = core::targetOf(view);
        if (!traced) {
            return traced.error();
        }
        look.target = std::make_shared<const core::Centerline2d>(std::move(traced).value());
    }
    const auto input = core::registrationInputOf(view, *look.target);
    if (!input) {
        return input.error();
    }
    const auto judged = core::evaluatePose(input.value(), view.cameraFromPatient);
    if (!judged) {
        return judged.error();
    }
    look.metrics = judged.value().metrics;
    return core::Done{};
}

void draw(ViewLook& look, const core::RegistrationCase& view, int widthPx)
{
    if (auto picture = drawThumbnail(view, widthPx)) {
        look.picture = std::move(picture).value();
    } else {
        look.problem = picture.error().message;
    }
}

void lookAt(ViewLook& look, const core::RegistrationCase& view, int widthPx)
{
    draw(look, view, widthPx);
    if (const auto judged = judge(look, view); !judged) {
        look.problem = judged.error().message;
    }
}

}   // namespace

std::vector<ViewLook> lookAtViews(const core::RegistrationCase& registrationCase,
                                  const std::shared_ptr<const core::Centerline2d>& ownTarget,
                                  const std::vector<ViewLook>& known, int widthPx)
{
    std::vector<ViewLook> looks(1);
    looks.front().target = ownTarget;
    lookAt(looks.front(), registrationCase, widthPx);
    for (const core::OtherView& other : registrationCase.otherViews) {
        ViewLook& look = looks.emplace_back();
        look.view = other.view;
        if (!other.view || !other.view->angiogram) {
            continue;
        }
        look.target = knownTarget(known, other.view);
        lookAt(look, core::withView(registrationCase, *other.view), widthPx);
    }
    return looks;
}

}   // namespace angiopose::app