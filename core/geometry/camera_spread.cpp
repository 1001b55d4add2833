#include "core/geometry/camera_spread.h"

#include <cmath>

namespace angiopose::core {
namespace {

/// Relative standard deviations (1 σ) by origin; DECISIONS gives the reasons for the values.
struct OriginShares {
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

constexpr OriginShares ofDistance{0.025, 0.03, 0.025, 0.05};   // standard deviations of the source-to-detector distance
constexpr OriginShares ofSpacing{0.015, 0.025, 0.015, 0.05};
// Error of the principal point divided by the focal length, that is, the angular error of the central ray.
constexpr OriginShares ofCentralRay{0.004, 0.004, 0.003, 0.004};

}   // namespace

CameraSpread spreadByOrigin(const CArm& cArm, const ProjectionCamera& camera)
{
    const double distance = ofDistance.of(cArm.sourceToDetectorMm.origin);
    const double spacing = ofSpacing.of(cArm.columnSpacingMm.origin);
    return {std::hypot(distance, spacing), ofCentralRay.of(cArm.principalPointPx.origin) * std::abs(camera.fx)};
}

CameraSpread spreadOfTyped(const ProjectionCamera& camera)
{
    return {std::hypot(ofDistance.typed, ofSpacing.typed), ofCentralRay.typed * std::abs(camera.fx)};
}

ProjectionCamera corrected(const ProjectionCamera& camera, const CameraError& error)
{
    ProjectionCamera better = camera;
    better.fx *= std::exp(error[0]);
    better.fy *= std::exp(error[0]);
    better.cx += error[1];
    better.cy += error[2];
    return better;
}

CArm corrected(CArm cArm, const ProjectionCamera& camera, const CameraError& error, const std::string& basis)
{
    const double factor = std::exp(error[0]);
    const auto scale = [&basis](Sourced<double>& value, double by) {
        if (value.value) {
            value = {*value.value * by, Origin::Derived, basis};
        }
    };
    if (ofDistance.of(cArm.sourceToDetectorMm.origin) >= ofSpacing.of(cArm.columnSpacingMm.origin)) {
        scale(cArm.sourceToDetectorMm, factor);
    } else {
        scale(cArm.columnSpacingMm, 1.0 / factor);
        scale(cArm.rowSpacingMm, 1.0 / factor);
    }
    const ProjectionCamera better = corrected(camera, error);
    cArm.principalPointPx = {Eigen::Vector2d(better.cx, better.cy), Origin::Derived, basis};
    return cArm;
}

}   // namespace angiopose::core
