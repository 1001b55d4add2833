#include "app/library/case_content.h"
#include "app/library/conversions.h"
#include "app/library/relay.h"
#include "core/case/registration_input.h"
#include "core/workflow/register_case.h"

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
    return valueOf(core::registrationInputOf(values, valueOf(core::targetOf(values.shown(), values.options.method))));
}

/// Every view that has an image knows where it starts; one without is told of by the run.
void requireStarts(const core::Case& values)
{
    for (const core::View& view : values.views) {
        if (view.angiogram) {
            requireStart(view, values.vessels);
        }
    }
}

core::RegisteredCase registered(const core::Case& values, Relay& relay)
{
    return relay.take(core::registerCase(values, {}, relay.working()));
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
    library::requireStarts(values);
    library::Relay relay(observe);
    values = library::registered(values, relay).theCase;
    return library::toPublic(*values.shown().result, *values.vessels.tree);
}

MultiViewResult registerViews(Case& theCase, const Observer& observe)
{
    core::Case& values = theCase.content().values;
    if (values.views.size() < 2) {
        throw Error("library.one-view", "The case has one view of the vessels. Register it with registerCase.");
    }
    library::requireStarts(values);
    library::Relay relay(observe);
    core::RegisteredCase run = library::registered(values, relay);
    values = std::move(run.theCase);
    return library::toPublic(*run.joint, *values.vessels.tree);
}

}   // namespace angiopose
