#include "core/geometry/camera_uncertainty.h"

#include <cmath>

namespace angiopose::core {
namespace {

/// Relative standard deviations (1 σ) by origin; DECISIONS gives the reasons for the values.
struct OriginUncertainty {
    double header, derived, typed, assumed;

    double of(Origin origin) const
    {
        switch (origin) {
            case Origin::Header:
                return header;
            case Origin::Derived:
                return derived;
            case Origin::User:
                return typed;
            case Origin::Missing:
            case Origin::Assumed:
                break;
        }
        return assumed;
    }
};

constexpr OriginUncertainty distanceUncertainty{0.025, 0.03, 0.025,
                                                0.05};   // standard deviations of the source-to-detector distance
constexpr OriginUncertainty spacingUncertainty{0.015, 0.025, 0.015, 0.05};
// Error of the principal point divided by the focal length, that is, the angular error of the central ray.
constexpr OriginUncertainty centralRayUncertainty{0.004, 0.004, 0.003, 0.004};

}   // namespace

CameraUncertainty uncertaintyByOrigin(const CArm& cArm, const ProjectionCamera& camera)
{
    const double distance = distanceUncertainty.of(cArm.sourceToDetectorMm.origin);
    const double spacing = spacingUncertainty.of(cArm.columnSpacingMm.origin);
    return {std::hypot(distance, spacing),
            centralRayUncertainty.of(cArm.principalPointPx.origin) * std::abs(camera.fx)};
}

CameraUncertainty enteredCameraUncertainty(const ProjectionCamera& camera)
{
    return {std::hypot(distanceUncertainty.typed, spacingUncertainty.typed),
            centralRayUncertainty.typed * std::abs(camera.fx)};
}

ProjectionCamera applyCameraError(const ProjectionCamera& camera, const CameraError& error)
{
    ProjectionCamera correctedCamera = camera;
    correctedCamera.fx *= std::exp(error[0]);
    correctedCamera.fy *= std::exp(error[0]);
    correctedCamera.cx += error[1];
    correctedCamera.cy += error[2];
    return correctedCamera;
}

CArm applyCameraError(CArm cArm, const ProjectionCamera& camera, const CameraError& error, const std::string& basis)
{
    const double factor = std::exp(error[0]);
    const auto scale = [&basis](SourcedValue<double>& value, double by) {
        if (value.value) {
            value = {*value.value * by, Origin::Derived, basis};
        }
    };
    if (distanceUncertainty.of(cArm.sourceToDetectorMm.origin) >= spacingUncertainty.of(cArm.columnSpacingMm.origin)) {
        scale(cArm.sourceToDetectorMm, factor);
    } else {
        scale(cArm.columnSpacingMm, 1.0 / factor);
        scale(cArm.rowSpacingMm, 1.0 / factor);
    }
    const ProjectionCamera correctedCamera = applyCameraError(camera, error);
    cArm.principalPointPx = {Eigen::Vector2d(correctedCamera.cx, correctedCamera.cy), Origin::Derived, basis};
    return cArm;
}

}   // namespace angiopose::core
