#include "core/joint_case.h"

#include <cassert>

namespace core {
namespace {

Error inView(std::size_t index, const Error& error)
{
    return {"View " + std::to_string(index + 1) + ": " + error.message};
}

/// The view with the vessels of the first, and the isocentre that all views turn about.
RegistrationCase withVesselsOf(const RegistrationCase& first, RegistrationCase view)
{
    view.tree = first.tree;
    view.volume = first.volume;
    view.auxiliaryBranchIds = first.auxiliaryBranchIds;
    view.excludedBranchIds = first.excludedBranchIds;
    if (first.cArm.isocentreInPatientMm.value) {
        view.cArm.isocentreInPatientMm = first.cArm.isocentreInPatientMm;
    }
    return view;
}

}   // namespace

Result<std::vector<RegistrationInput>> jointInputsOf(std::span<const RegistrationCase> views,
                                                     std::span<const Centerline2d> targets)
{
    assert(views.size() == targets.size());
    std::vector<RegistrationInput> inputs;
    RigidTransform firstStartInverse;
    for (std::size_t k = 0; k < views.size(); ++k) {
        RegistrationCase view = withVesselsOf(views.front(), views[k]);
        const auto start = startPoseOf(view);
        if (!start) {
            return inView(k, start.error());
        }
        if (k == 0) {
            firstStartInverse = start.value().inverse();
        }
        if (k > 0) {
            view.cameraFromPatient = start.value() * firstStartInverse * views.front().cameraFromPatient;
        }
        auto input = registrationInputOf(view, targets[k]);
        if (!input) {
            return inView(k, input.error());
        }
        inputs.push_back(std::move(input).value());
    }
    return inputs;
}

}   // namespace core
