#include "app/files/view_from_inputs.h"

#include "app/files/assemble_case.h"
#include "app/messages/says.h"
#include "core/case_views.h"
#include "core/joint_case.h"

#include <memory>

namespace angiopose::app {
namespace {

/// The case with the image that was opened in place of its own, at its start pose.
core::RegistrationCase withImageOf(core::RegistrationCase registrationCase, const LoadedInputs& inputs)
{
    registrationCase.snapshots.clear();
    registrationCase.traceOptions = {};
    registrationCase.cameraFromPatient = {};
    registrationCase.initialCameraFromPatient = {};
    LoadedInputs imageOnly;
    imageOnly.angiogram = inputs.angiogram;
    imageOnly.imageFile = inputs.imageFile;
    imageOnly.headerPlan = inputs.headerPlan;
    imageOnly.target = inputs.target;
    imageOnly.targetFile = inputs.targetFile;
    return withInputs(std::move(registrationCase), imageOnly);
}

}   // namespace

core::Result<core::OtherView> viewFrom(const core::RegistrationCase& registrationCase, const LoadedInputs& inputs,
                                       const std::string& path)
{
    if (inputs.wholeCase && inputs.wholeCase->angiogram) {
        return core::OtherView{{path, {}},
                               std::make_shared<const core::RegistrationCase>(core::viewOf(*inputs.wholeCase))};
    }
    if (!inputs.angiogram) {
        return core::Error(says::openNoAngiogram().about(path));
    }
    core::RegistrationCase view = withImageOf(registrationCase, inputs);
    if (const auto fromShown = core::viewFromView(registrationCase, view)) {
        view.cameraFromPatient = fromShown.value() * registrationCase.cameraFromPatient;
        if (registrationCase.hasInitialPose) {   // vessels may have axes of their own, which angles know nothing about
            view.hasInitialPose = true;
            view.initialCameraFromPatient = fromShown.value() * registrationCase.initialCameraFromPatient;
        }
    }
    return core::OtherView{{}, std::make_shared<const core::RegistrationCase>(core::viewOf(view))};
}

}   // namespace angiopose::app