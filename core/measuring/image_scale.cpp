#include "core/measuring/image_scale.h"

#include "core/messages/messages.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace angiopose::core {
namespace {

/// Returns the least certain origin.
Origin weakestOrigin(const std::vector<Origin>& origins)
{
    constexpr std::array order{Origin::Header, Origin::Derived, Origin::User, Origin::Assumed, Origin::Missing};
    const auto rank = [&order](Origin origin) { return std::ranges::find(order, origin); };
    return *std::ranges::max_element(origins, {}, rank);
}

Result<ImageScale> scaleAtVessels(const MeasurementContext& context)
{
    const View& view = context.view;
    const VesselTree* tree = context.tree;
    const auto camera = cameraOf(view);
    if (!camera) {
        return camera.error();
    }
    if (!tree || tree->pointCount() == 0) {
        return Error(messages::measureNeedsVessels());
    }
    const double depthMm = (context.cameraFromPatient * centroidInPatient(*tree)).z();
    if (!(depthMm >= minProjectableDepthMm)) {   // also true for NaN
        return Error(messages::measureBehindSource());
    }
    const CArm& cArm = view.geometry.cArm;
    const Origin origin =
        view.geometry.cameraOverride
            ? Origin::User
            : weakestOrigin({cArm.sourceToDetectorMm.origin, cArm.columnSpacingMm.origin, cArm.rowSpacingMm.origin});
    return ImageScale{MeasurementPlane::Vessels,
                      {depthMm / std::abs(camera.value().fx), depthMm / std::abs(camera.value().fy)},
                      depthMm,
                      origin};
}

Result<ImageScale> scaleAtDetector(const View& view)
{
    const CArm& cArm = view.geometry.cArm;
    const auto isLength = [](const SourcedValue<double>& length) {
        return length.value && std::isfinite(*length.value) && *length.value > 0.0;
    };
    if (!isLength(cArm.columnSpacingMm) || !isLength(cArm.rowSpacingMm)) {
        return Error(messages::measureNeedsSpacing());
    }
    return ImageScale{MeasurementPlane::Detector,
                      {*cArm.columnSpacingMm.value, *cArm.rowSpacingMm.value},
                      0.0,
                      weakestOrigin({cArm.columnSpacingMm.origin, cArm.rowSpacingMm.origin})};
}

Result<ImageScale> enteredScale(const View& view)
{
    if (!view.enteredMmPerPx || !(*view.enteredMmPerPx > 0.0) || !std::isfinite(*view.enteredMmPerPx)) {
        return Error(messages::measureNeedsEnteredScale());
    }
    return ImageScale{MeasurementPlane::Typed, Eigen::Vector2d::Constant(*view.enteredMmPerPx), 0.0, Origin::User};
}

}   // namespace

const RegistrationResult* MeasurementContext::result() const
{
    const bool isOwn = cameraFromPatient.matrix() == view.cameraFromPatient.matrix();
    return isOwn && view.result ? &*view.result : nullptr;
}

Result<ImageScale> imageScaleOf(const MeasurementContext& context, MeasurementPlane plane)
{
    switch (plane) {
        case MeasurementPlane::Vessels:
            return scaleAtVessels(context);
        case MeasurementPlane::Detector:
            return scaleAtDetector(context.view);
        case MeasurementPlane::Typed:
            return enteredScale(context.view);
        case MeasurementPlane::Pixels:
            break;
    }
    return ImageScale{};
}

MeasurementPlane preferredPlane(const MeasurementContext& context)
{
    for (const MeasurementPlane plane :
         {MeasurementPlane::Vessels, MeasurementPlane::Typed, MeasurementPlane::Detector}) {
        if (imageScaleOf(context, plane)) {
            return plane;
        }
    }
    return MeasurementPlane::Pixels;
}

}   // namespace angiopose::core
