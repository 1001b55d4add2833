#include "core/workflow/bend_case.h"

#include "core/case/registration_input.h"

#include <utility>

namespace angiopose::core {
namespace {

// What is left of the headers' errors once views are registered together.
constexpr double jointGeometryDeg = 0.1;
constexpr double jointGeometryMm = 0.3;

}   // namespace

Result<DeformableResult> bendCase(const RegisteredCase& registered, DeformableOptions options,
                                  const IterationObserver& observe)
{
    std::vector<DeformableView> views;
    for (std::size_t k = 0; k < registered.places.size(); ++k) {
        const View& view = registered.theCase.views[registered.places[k]];
        auto input = registrationInputOf(view, registered.theCase.vessels, registered.targets[k]);
        if (!input) {
            return input.error();
        }
        views.push_back({std::move(input).value(), view.cameraFromPatient, registered.places[k] + 1});
    }
    if (views.size() > 1) {
        options.geometryDeg = jointGeometryDeg;
        options.geometryMm = jointGeometryMm;
    }
    return deformVessels(views, options, observe);
}

}   // namespace angiopose::core
