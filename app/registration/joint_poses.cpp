#include "app/registration/joint_poses.h"

#include "app/review/snapshot_texts.h"
#include "core/case_views.h"

#include <algorithm>

namespace angiopose::app {
namespace {

core::RegistrationCase withResult(core::RegistrationCase view, const core::RegistrationResult& result)
{
    view.cameraFromPatient = result.cameraFromPatient;
    view.result = result;
    view.snapshots = core::withSnapshot(std::move(view.snapshots), snapshotOfRun(result, view.frame));
    return view;
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

JointPoses jointPosesOf(const core::RegistrationCase& registrationCase, const core::MultiViewResult& joint)
{
    JointPoses poses{withResult(registrationCase, ownResult(joint)), registrationCase.otherViews};
    std::size_t k = 1;
    for (core::OtherView& other : poses.others) {
        if (other.view && other.view->angiogram) {
            other = {{}, std::make_shared<const core::RegistrationCase>(withResult(*other.view, joint.views[k++]))};
        }
    }
    return poses;
}

}   // namespace angiopose::app