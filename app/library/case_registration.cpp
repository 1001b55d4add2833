#include "app/library/case_content.h"
#include "app/library/conversions.h"
#include "app/library/relay.h"
#include "core/case/case_views.h"
#include "core/case/registration_input.h"

namespace angiopose::library {
namespace {

/// Where the vessels are told to be: a pose that nobody gave would be the identity.
void requireStart(const core::View& view, const core::Vessels& vessels)
{
    if (auto start = core::startPoseOf(view, vessels); !start) {
        throw Error("library.no-start",
                    "The geometry of the angiogram gives no start pose; set one. " + start.error().message.text());
    }
}

core::RegistrationInput coreInputOf(const core::Case& values)
{
    requireStart(values.shown(), values.vessels);
    return valueOf(core::registrationInputOf(values, valueOf(core::targetOf(values.shown()))));
}

void requireImages(const core::Case& values)
{
    for (const core::View& view : values.views) {
        if (!view.angiogram) {
            const std::string& path = view.imageFile.path.empty() ? view.caseFile.path : view.imageFile.path;
            throw Error("library.no-view", path + ": the image of this view could not be read.");
        }
    }
}

std::vector<core::RegistrationInput> jointInputsOf(const core::Case& values)
{
    requireImages(values);
    const std::vector<core::View> views = core::viewsAt(values, core::registeredViews(values));
    std::vector<core::Centerline2d> targets;
    for (const core::View& view : views) {
        requireStart(view, values.vessels);
        targets.push_back(valueOf(core::targetOf(view)));
    }
    return valueOf(core::jointInputsOf(views, values.vessels, targets));
}

void takeOver(core::Case& values, const core::RegistrationResult& result)
{
    values.views = core::movedAlong(values, result.cameraFromPatient);
    values.shown().result = result;
}

}   // namespace
}   // namespace angiopose::library

namespace angiopose {

Centerline2d targetOf(const Case& theCase)
{
    return library::toPublic(library::valueOf(core::targetOf(theCase.content().values.shown())));
}

RegistrationInput inputOf(const Case& theCase)
{
    return library::toPublic(library::coreInputOf(theCase.content().values));
}

RegistrationResult registerCase(Case& theCase, const Observer& observe)
{
    core::Case& values = theCase.content().values;
    if (values.views.size() > 1) {
        throw Error("library.several-views", "The case has " + std::to_string(theCase.viewCount()) +
                                                 " views of the vessels. Register them together with registerViews.");
    }
    library::Relay relay(observe);
    const core::RegistrationResult result =
        relay.take(core::registerVessels(library::coreInputOf(values), values.options, relay.iterations()));
    library::takeOver(values, result);
    return library::toPublic(result);
}

MultiViewResult registerViews(Case& theCase, const Observer& observe)
{
    core::Case& values = theCase.content().values;
    library::Relay relay(observe);
    const core::MultiViewResult joint =
        relay.take(core::registerViews(library::jointInputsOf(values), values.options, {}, relay.iterations()));
    core::RegistrationResult shown = joint.views.front();
    shown.uncertainty = joint.uncertainty;
    library::takeOver(values, shown);
    return library::toPublic(joint);
}

}   // namespace angiopose
