#include "app/registration/joint_poses.h"

#include "app/review/snapshot_texts.h"
#include "core/case/case_views.h"

#include <algorithm>

namespace angiopose::app {
namespace {

void takeOver(core::View& view, const core::RegistrationResult& result)
{
    view.caseFile = {};
    view.cameraFromPatient = result.cameraFromPatient;
    view.result = result;
    view.snapshots = core::withSnapshot(std::move(view.snapshots), snapshotOfRun(result, view.frame));
}

/// What holds for all views together belongs to the shown one: its depth is known from the others.
core::RegistrationResult ownResult(const core::MultiViewResult& joint)
{
    core::RegistrationResult result = joint.views.front();
    result.uncertainty = joint.uncertainty;
    result.trustworthy = joint.trustworthy;
    for (const core::Message& warning : joint.warnings) {
        if (std::ranges::find(result.warnings, warning) == result.warnings.end()) {
            result.warnings.push_back(warning);
        }
    }
    return result;
}

}   // namespace

std::vector<core::View> viewsAfter(const core::Case& theCase, const core::MultiViewResult& joint)
{
    std::vector<core::View> views = theCase.views;
    const std::vector<std::size_t> places = core::registeredViews(theCase);
    for (std::size_t k = 0; k < places.size(); ++k) {
        takeOver(views[places[k]], k == 0 ? ownResult(joint) : joint.views[k]);
    }
    return views;
}

}   // namespace angiopose::app
