#include "core/joint_case.h"

#include "core/registration/register_views.h"

#include <cassert>

namespace angiopose::core {
namespace {

RegistrationCase withVesselsOf(const RegistrationCase& first, RegistrationCase view)
{
    view.tree = first.tree;
    view.volume = first.volume;
    view.auxiliaryBranchIds = first.auxiliaryBranchIds;
    view.excludedBranchIds = first.excludedBranchIds;
    view.pickedPivotInPatient = first.pickedPivotInPatient;
    return view;
}

}   // namespace

Result<RigidTransform> viewFromView(const RegistrationCase& first, const RegistrationCase& view)
{
    const Eigen::Vector3d anyIsocentre = Eigen::Vector3d::Zero();   // the same for both: it cancels
    const auto gantryOfFirst = cameraFromPatient(cArmOfFrame(first), anyIsocentre);
    const auto gantry = cameraFromPatient(cArmOfFrame(view), anyIsocentre);
    if (gantryOfFirst && gantry) {
        return gantry.value() * gantryOfFirst.value().inverse();
    }
    const auto startOfFirst = startPoseOf(first);
    const auto start = startPoseOf(view);
    return startOfFirst && start ? Result<RigidTransform>(start.value() * startOfFirst.value().inverse())
           : start               ? startOfFirst.error()
                                 : start.error();
}

Result<std::vector<RegistrationInput>> jointInputsOf(std::span<const RegistrationCase> views,
                                                     std::span<const Centerline2d> targets)
{
    assert(views.size() == targets.size());
    std::vector<RegistrationInput> inputs;
    const RegistrationCase& first = views.front();
    for (std::size_t k = 0; k < views.size(); ++k) {
        RegistrationCase view = withVesselsOf(first, views[k]);
        if (k > 0) {
            const auto fromFirst = viewFromView(first, view);
            if (!fromFirst) {
                return inView(k, fromFirst.error());
            }
            view.cameraFromPatient = fromFirst.value() * first.cameraFromPatient;
        }
        auto input = registrationInputOf(view, targets[k]);
        if (!input) {
            return inView(k, input.error());
        }
        inputs.push_back(std::move(input).value());
    }
    return inputs;
}

}   // namespace angiopose::core