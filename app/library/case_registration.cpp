#include "app/library/case_content.h"
#include "app/library/conversions.h"
#include "app/library/relay.h"
#include "core/case_views.h"
#include "core/joint_case.h"
#include "io/case_file.h"

namespace angiopose::library {
namespace {

/// Where the vessels are told to be: a pose that nobody gave would be the identity.
void requireStart(const core::RegistrationCase& values)
{
    if (auto start = core::startPoseOf(values); !start) {
        throw Error("library.no-start",
                    "The geometry of the angiogram gives no start pose; set one. " + start.error().message.text());
    }
}

core::RegistrationInput coreInputOf(const core::RegistrationCase& values)
{
    requireStart(values);
    return valueOf(core::registrationInputOf(values, valueOf(core::targetOf(values))));
}

/// As it stands in the case, or in the case file that it refers to.
core::RegistrationCase viewOf(const core::RegistrationCase& first, const core::OtherView& other)
{
    if (other.view && other.view->angiogram) {
        return core::withView(first, *other.view);
    }
    if (other.file.path.empty()) {
        throw Error("library.no-view", other.view->imageFile.path + ": the image of this view could not be read.");
    }
    core::Messages warnings;
    return valueOf(io::loadCase(other.file.path, warnings));
}

std::vector<core::RegistrationInput> jointInputsOf(const core::RegistrationCase& first)
{
    std::vector<core::RegistrationCase> views{first};
    for (const core::OtherView& other : first.otherViews) {
        views.push_back(viewOf(first, other));
    }
    std::vector<core::Centerline2d> targets;
    for (const core::RegistrationCase& view : views) {
        requireStart(view);
        targets.push_back(valueOf(core::targetOf(view)));
    }
    return valueOf(core::jointInputsOf(views, targets));
}

void takeOver(core::RegistrationCase& values, const core::RegistrationResult& result)
{
    values.otherViews = core::movedAlong(values, result.cameraFromPatient);
    values.cameraFromPatient = result.cameraFromPatient;
    values.result = result;
}

}   // namespace
}   // namespace angiopose::library

namespace angiopose {

Centerline2d targetOf(const Case& theCase)
{
    return library::toPublic(library::valueOf(core::targetOf(theCase.content().values)));
}

RegistrationInput inputOf(const Case& theCase)
{
    return library::toPublic(library::coreInputOf(theCase.content().values));
}

RegistrationResult registerCase(Case& theCase, const Observer& observe)
{
    core::RegistrationCase& values = theCase.content().values;
    if (!values.otherViews.empty()) {
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
    core::RegistrationCase& values = theCase.content().values;
    library::Relay relay(observe);
    const core::MultiViewResult joint =
        relay.take(core::registerViews(library::jointInputsOf(values), values.options, {}, relay.iterations()));
    core::RegistrationResult shown = joint.views.front();
    shown.uncertainty = joint.uncertainty;
    library::takeOver(values, shown);
    return library::toPublic(joint);
}

}   // namespace angiopose
