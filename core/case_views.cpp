#include "core/case_views.h"

#include <tuple>
#include <utility>

namespace core {
namespace {

template <class Case>
auto viewFields(Case& values)
{
    return std::tie(values.imageFile, values.angiogram, values.storedRun, values.headerPlan, values.treatment,
                    values.frame, values.targetFile, values.givenTarget, values.editedFrame, values.acceptedCurveIds,
                    values.traceOptions, values.cArm, values.cameraOverride, values.hasInitialPose,
                    values.initialCameraFromPatient, values.cameraFromPatient, values.landmarks, values.result,
                    values.snapshots);
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

}   // namespace core
