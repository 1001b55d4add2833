#include "core/case/case_views.h"

#include <algorithm>
#include <utility>

namespace angiopose::core {
namespace {

/// Returns the case's views; every registered view gets the pose `poseOf(index)`, the others stay unchanged.
template <class PoseOf>
std::vector<View> withPoses(const Case& session, const PoseOf& poseOf)
{
    std::vector<View> views = session.views;
    for (const std::size_t place : registeredViews(session)) {
        View& view = views[place];
        view.cameraFromPatient = poseOf(place);
        forgetFindings(view);
        view.caseFile = {};
    }
    return views;
}

}   // namespace

Case showingView(Case session, std::size_t index)
{
    session.shownView = index;
    session.shown().caseFile = {};
    return session;
}

Case withoutView(Case session, std::size_t index)
{
    std::vector<std::size_t> places = registeredViews(session);
    if (index == session.shownView) {
        if (places.size() < 2) {
            return session;
        }
        session = showingView(std::move(session), places[1]);
    }
    session.views.erase(session.views.begin() + static_cast<std::ptrdiff_t>(index));
    session.shownView -= index < session.shownView ? 1 : 0;
    return session;
}

std::vector<std::size_t> registeredViews(const Case& session)
{
    std::vector<std::size_t> places{session.shownView};
    for (std::size_t k = 0; k < session.views.size(); ++k) {
        if (k != session.shownView && session.views[k].angiogram) {
            places.push_back(k);
        }
    }
    return places;
}

std::vector<View> viewsAt(const Case& session, const std::vector<std::size_t>& places)
{
    std::vector<View> views;
    std::ranges::transform(places, std::back_inserter(views), [&](std::size_t place) { return session.views[place]; });
    return views;
}

RigidTransform poseMovedAlong(const Case& session, std::size_t place, const RigidTransform& cameraFromPatient)
{
    if (place == session.shownView) {
        return cameraFromPatient;   // avoids rounding errors for the shown view
    }
    const RigidTransform patientMotion = session.shown().cameraFromPatient.inverse() * cameraFromPatient;
    return session.views[place].cameraFromPatient * patientMotion;
}

std::vector<View> movedAlong(const Case& session, const RigidTransform& cameraFromPatient)
{
    return withPoses(session, [&](std::size_t place) { return poseMovedAlong(session, place, cameraFromPatient); });
}

std::vector<View> atStart(const Case& session)
{
    return withPoses(session, [&session](std::size_t place) {
        const View& view = session.views[place];
        const auto start = initialPoseOf(view, session.vessels);
        return start ? start.value() : view.cameraFromPatient;
    });
}

}   // namespace angiopose::core
