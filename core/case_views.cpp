#include "core/case_views.h"

#include <tuple>
#include <utility>

namespace angiopose::core {
namespace {

template <class Case>
auto viewFields(Case& values)
{
    return std::tie(values.imageFile, values.angiogram, values.storedRun, values.headerPlan, values.treatment,
                    values.frame, values.targetFile, values.givenTarget, values.editedFrame, values.acceptedCurveIds,
                    values.traceOptions, values.cArm, values.cameraOverride, values.hasInitialPose,
                    values.initialCameraFromPatient, values.cameraFromPatient, values.landmarks, values.result,
                    values.snapshots, values.viewExtraKeys);
}

/// The other views with an image, each with its pose from `poseOf`.
template <class PoseOf>
std::vector<OtherView> withPoses(const RegistrationCase& registrationCase, const PoseOf& poseOf)
{
    std::vector<OtherView> others = registrationCase.otherViews;
    for (OtherView& other : others) {
        if (other.view && other.view->angiogram) {
            RegistrationCase moved = *other.view;
            moved.cameraFromPatient = poseOf(*other.view);
            moved.result.reset();
            other = {{}, std::make_shared<const RegistrationCase>(std::move(moved))};
        }
    }
    return others;
}

}   // namespace

RegistrationCase viewOf(const RegistrationCase& registrationCase)
{
    return withView({}, registrationCase);
}

RegistrationCase withView(RegistrationCase registrationCase, const RegistrationCase& view)
{
    viewFields(registrationCase) = viewFields(view);
    return registrationCase;
}

RegistrationCase showingView(RegistrationCase registrationCase, std::size_t index)
{
    OtherView& place = registrationCase.otherViews.at(index);
    const auto shown = place.view;
    place = {{}, std::make_shared<const RegistrationCase>(viewOf(registrationCase))};
    return withView(std::move(registrationCase), *shown);
}

std::vector<OtherView> movedAlong(const RegistrationCase& registrationCase, const RigidTransform& cameraFromPatient)
{
    const RigidTransform patientMotion = registrationCase.cameraFromPatient.inverse() * cameraFromPatient;
    return withPoses(registrationCase,
                     [&patientMotion](const RegistrationCase& view) { return view.cameraFromPatient * patientMotion; });
}

std::vector<OtherView> atStart(const RegistrationCase& registrationCase)
{
    return withPoses(registrationCase, [&registrationCase](const RegistrationCase& view) {
        const auto start = startPoseOf(withView(registrationCase, view));
        return start ? start.value() : view.cameraFromPatient;
    });
}

std::vector<RegistrationCase> casesOfViews(const RegistrationCase& registrationCase)
{
    std::vector<RegistrationCase> cases{registrationCase};
    for (const OtherView& other : registrationCase.otherViews) {
        if (other.view && other.view->angiogram) {
            cases.push_back(withView(registrationCase, *other.view));
        }
    }
    return cases;
}

}   // namespace angiopose::core