#include "core/case/case_views.h"

#include <algorithm>
#include <utility>

namespace angiopose::core {
namespace {

/// The registered views, each with its pose from `poseOf` its place; the others as they are.
template <class PoseOf>
std::vector<View> withPoses(const Case& theCase, const PoseOf& poseOf)
{
    std::vector<View> views = theCase.views;
    for (const std::size_t place : registeredViews(theCase)) {
        View& view = views[place];
        view.cameraFromPatient = poseOf(place);
        forgetFindings(view);
        view.caseFile = {};
    }
    return views;
}

}   // namespace

Case showingView(Case theCase, std::size_t index)
{
    theCase.shownView = index;
    theCase.shown().caseFile = {};
    return theCase;
}

Case withoutView(Case theCase, std::size_t index)
{
    std::vector<std::size_t> places = registeredViews(theCase);
    if (index == theCase.shownView) {
        if (places.size() < 2) {
            return theCase;
        }
        theCase = showingView(std::move(theCase), places[1]);
    }
    theCase.views.erase(theCase.views.begin() + static_cast<std::ptrdiff_t>(index));
    theCase.shownView -= index < theCase.shownView ? 1 : 0;
    return theCase;
}

std::vector<std::size_t> registeredViews(const Case& theCase)
{
    std::vector<std::size_t> places{theCase.shownView};
    for (std::size_t k = 0; k < theCase.views.size(); ++k) {
        if (k != theCase.shownView && theCase.views[k].angiogram) {
            places.push_back(k);
        }
    }
    return places;
}

std::vector<View> viewsAt(const Case& theCase, const std::vector<std::size_t>& places)
{
    std::vector<View> views;
    std::ranges::transform(places, std::back_inserter(views), [&](std::size_t place) { return theCase.views[place]; });
    return views;
}

RigidTransform poseMovedAlong(const Case& theCase, std::size_t place, const RigidTransform& cameraFromPatient)
{
    if (place == theCase.shownView) {
        return cameraFromPatient;   // to the last bit
    }
    const RigidTransform patientMotion = theCase.shown().cameraFromPatient.inverse() * cameraFromPatient;
    return theCase.views[place].cameraFromPatient * patientMotion;
}

std::vector<View> movedAlong(const Case& theCase, const RigidTransform& cameraFromPatient)
{
    return withPoses(theCase, [&](std::size_t place) { return poseMovedAlong(theCase, place, cameraFromPatient); });
}

std::vector<View> atStart(const Case& theCase)
{
    return withPoses(theCase, [&theCase](std::size_t place) {
        const View& view = theCase.views[place];
        const auto start = startPoseOf(view, theCase.vessels);
        return start ? start.value() : view.cameraFromPatient;
    });
}

}   // namespace angiopose::core
