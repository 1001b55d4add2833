#include "core/case/estimated_geometry.h"

#include "core/registration/alignment/camera_influence.h"

#include <algorithm>

namespace angiopose::core {

namespace {

constexpr double significantSigmas = 0.5;

}   // namespace

/// Returns true for a single view only if the pose had converged.
bool isGeometryContradicted(const View& view, std::size_t viewCount)
{
    const auto camera = cameraOf(view);
    if (!camera || !view.result || !view.result->camera) {
        return false;
    }
    const Messages found = contradictionsOf(*view.result->camera, camera.value(), viewCount);
    return viewCount > 1 ? !found.empty() : std::ranges::any_of(found, [&](const Message& each) {
        return std::ranges::find(view.result->warnings, each) != view.result->warnings.end();
    });
}

std::optional<CameraError> applyEstimatedGeometry(View& view)
{
    const auto camera = cameraOf(view);
    if (!camera || !view.result || !view.result->camera ||
        view.result->camera->error.cwiseQuotient(view.result->camera->std).cwiseAbs().maxCoeff() < significantSigmas) {
        return std::nullopt;
    }
    const CameraError error = view.result->camera->error;
    ViewGeometry& geometry = view.geometry;
    if (geometry.cameraOverride) {
        geometry.cameraOverride = applyCameraError(*geometry.cameraOverride, error);
    } else {
        geometry.cArm =
            applyCameraError(geometry.cArm, camera.value(), error, "estimated from the vessels in the images");
    }
    return error;
}

}   // namespace angiopose::core
