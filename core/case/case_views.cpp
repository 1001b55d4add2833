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
    for (const std::size_t viewIndex : registeredViews(session)) {
        View& view = views[viewIndex];
        view.cameraFromPatient = poseOf(viewIndex);
        discardResults(view);
        view.caseFile = {};
    }
    return views;
}

}   // namespace

Case withShownView(Case session, std::size_t index)
{
    session.shownView = index;
    session.shown().caseFile = {};
    return session;
}

Case withoutView(Case session, std::size_t index)
{
    std::vector<std::size_t> viewIndices = registeredViews(session);
    if (index == session.shownView) {
        if (viewIndices.size() < 2) {
            return session;
        }
        session = withShownView(std::move(session), viewIndices[1]);
    }
    session.views.erase(session.views.begin() + static_cast<std::ptrdiff_t>(index));
    session.shownView -= index < session.shownView ? 1 : 0;
    return session;
}

std::vector<std::size_t> registeredViews(const Case& session)
{
    std::vector<std::size_t> viewIndices{session.shownView};
    for (std::size_t k = 0; k < session.views.size(); ++k) {
        if (k != session.shownView && session.views[k].angiogram) {
            viewIndices.push_back(k);
        }
    }
    return viewIndices;
}

std::vector<View> viewsAt(const Case& session, const std::vector<std::size_t>& viewIndices)
{
    std::vector<View> views;
    std::ranges::transform(viewIndices, std::back_inserter(views),
                           [&](std::size_t viewIndex) { return session.views[viewIndex]; });
    return views;
}

RigidTransform poseAfterMotion(const Case& session, std::size_t viewIndex, const RigidTransform& cameraFromPatient)
{
    if (viewIndex == session.shownView) {
        return cameraFromPatient;   // avoids rounding errors for the shown view
    }
    const RigidTransform patientMotion = session.shown().cameraFromPatient.inverse() * cameraFromPatient;
    return session.views[viewIndex].cameraFromPatient * patientMotion;
}

std::vector<View> viewsAfterMotion(const Case& session, const RigidTransform& cameraFromPatient)
{
    return withPoses(session,
                     [&](std::size_t viewIndex) { return poseAfterMotion(session, viewIndex, cameraFromPatient); });
}

std::vector<View> viewsAtInitialPose(const Case& session)
{
    return withPoses(session, [&session](std::size_t viewIndex) {
        const View& view = session.views[viewIndex];
        const auto start = initialPoseOf(view, session.vessels);
        return start ? start.value() : view.cameraFromPatient;
    });
}

}   // namespace angiopose::core
