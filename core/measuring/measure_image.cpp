#include "core/measuring/measure_image.h"

#include "core/geometry/angle_units.h"
#include "core/messages/messages.h"
#include "core/vessel/polyline.h"

#include <algorithm>
#include <cmath>

namespace angiopose::core {
namespace {

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b)
{
    return a.x() * b.y() - a.y() * b.x();
}

/// Whether the segments a–b and c–d have an interior point in common.
bool segmentsIntersect(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c,
                       const Eigen::Vector2d& d)
{
    return cross(b - a, c - a) * cross(b - a, d - a) < 0.0 && cross(d - c, a - c) * cross(d - c, b - c) < 0.0;
}

bool isSelfIntersecting(const Polyline<2>& outline)
{
    const std::size_t count = outline.size();
    for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t j = i + 1; j < count; ++j) {
            if (segmentsIntersect(outline[i], outline[(i + 1) % count], outline[j], outline[(j + 1) % count])) {
                return true;
            }
        }
    }
    return false;
}

Result<Quantity> angleAt(const Polyline<2>& points)
{
    const Eigen::Vector2d one = points[0] - points[1];
    const Eigen::Vector2d other = points[2] - points[1];
    if (!(one.norm() > 0.0) || !(other.norm() > 0.0)) {
        return Error(messages::measureAngleDegenerate());
    }
    return Quantity{degreesPerRadian * std::abs(std::atan2(cross(one, other), one.dot(other))), 1, "°"};
}

Result<Quantity> areaOf(const Polyline<2>& outline, bool isInMm)
{
    if (isSelfIntersecting(outline)) {
        return Error(messages::measureSelfIntersecting());
    }
    double twice = 0.0;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        twice += cross(outline[i] - outline[0], outline[(i + 1) % outline.size()] - outline[0]);
    }
    return Quantity{0.5 * std::abs(twice), isInMm ? 1 : 0, isInMm ? "mm²" : "px²"};
}

Message basisSentence(const ImageMeasurementResult& imageResult, MeasurementKind kind)
{
    const ImageScale& scale = imageResult.scale;
    const Quantity pixel{std::sqrt(scale.unitsPerPx.prod()), 3, "mm"};
    if (kind == MeasurementKind::Angle) {
        return messages::measureBasisAngle();
    }
    switch (scale.plane) {
        case MeasurementPlane::Vessels:
            return messages::measureBasisVessels(Quantity{scale.depthMm, 0, "mm"}, pixel);
        case MeasurementPlane::Detector:
            return messages::measureBasisDetector(pixel);
        case MeasurementPlane::Typed:
            return messages::measureBasisEntered(pixel);
        case MeasurementPlane::Pixels:
            break;
    }
    return messages::measureBasisPixels();
}

/// Adds notes on the uncertainty of the vessel depth from which the length was computed.
void addDepthUncertainty(Messages& basis, const ImageScale& scale, const RegistrationResult* result)
{
    if (!result) {
        basis.push_back(messages::measureDepthUnchecked());
        return;
    }
    if (!result->trustworthy) {
        basis.push_back(messages::measurePoseUnreliable());
    }
    const double spreadMm = result->uncertainty.depthMm;
    if (std::isfinite(spreadMm) && spreadMm > 0.0) {
        basis.push_back(messages::measureDepthSpread(Quantity{spreadMm, 1, "mm"},
                                                     Quantity{100.0 * spreadMm / scale.depthMm, 1, "%"}));
    }
}

}   // namespace

std::size_t minPoints(MeasurementKind kind)
{
    return kind == MeasurementKind::Length ? 2 : 3;
}

Result<Quantity> valueOf(const ImageMeasurement& measurement, const ImageScale& scale)
{
    if (measurement.pixels.size() < minPoints(measurement.kind)) {
        return Error(messages::measurePoints(minPoints(measurement.kind), measurement.pixels.size()));
    }
    Polyline<2> points;
    for (const Eigen::Vector2d& pixel : measurement.pixels) {
        points.push_back(pixel.cwiseProduct(scale.unitsPerPx));
        if (!points.back().allFinite()) {
            return Error(messages::measureNotFinite());
        }
    }
    switch (measurement.kind) {
        case MeasurementKind::Angle:
            return angleAt(points);
        case MeasurementKind::Area:
            return areaOf(points, scale.isInMm());
        case MeasurementKind::Length:
            break;
    }
    return Quantity{polylineLength<2>(points), 1, scale.isInMm() ? "mm" : "px"};
}

Result<ImageMeasurementResult> measureImage(const ImageMeasurement& measurement, const MeasurementContext& context)
{
    const auto scale = imageScaleOf(context, measurement.plane);
    if (!scale) {
        return scale.error();
    }
    const auto value = valueOf(measurement, scale.value());
    if (!value) {
        return value.error();
    }
    return ImageMeasurementResult{value.value(), scale.value()};
}

Message labelOf(const ImageMeasurementResult& imageResult, MeasurementKind kind)
{
    if (kind == MeasurementKind::Angle || !imageResult.scale.isInMm()) {
        return messages::measuredPlain(imageResult.value);
    }
    if (imageResult.scale.plane == MeasurementPlane::Typed) {
        return messages::measuredWithEnteredScale(imageResult.value);
    }
    const Message label = imageResult.scale.plane == MeasurementPlane::Vessels
                              ? messages::measuredAtVessels(imageResult.value)
                              : messages::measuredAtDetector(imageResult.value);
    return imageResult.scale.origin == Origin::Assumed ? messages::measuredAssumed(label) : label;
}

Messages basisOf(const ImageMeasurementResult& imageResult, MeasurementKind kind, const MeasurementContext& context)
{
    Messages basis{basisSentence(imageResult, kind)};
    if (kind == MeasurementKind::Angle) {
        if (!imageResult.scale.isInMm()) {
            basis.push_back(messages::measureSquarePixels());
        }
        return basis;
    }
    if (imageResult.scale.isInMm() && imageResult.scale.origin == Origin::Assumed) {
        basis.push_back(messages::measureScaleAssumed());
    } else if (imageResult.scale.isInMm() && imageResult.scale.origin == Origin::User &&
               imageResult.scale.plane != MeasurementPlane::Typed) {
        basis.push_back(messages::measureScaleEntered());
    }
    if (imageResult.scale.plane == MeasurementPlane::Vessels) {
        addDepthUncertainty(basis, imageResult.scale, context.result());
    }
    return basis;
}

Result<Quantity> valueOf(const SliceMeasurement& measurement)
{
    const PlaneAxes axes = axesOf(measurement.plane);
    ImageMeasurement inPlane;
    inPlane.kind = measurement.kind;
    for (const Eigen::Vector3d& point : measurement.pointsInPatient) {
        inPlane.pixels.emplace_back(point.dot(axes.right), point.dot(axes.down));   // pixel units are millimeters
    }
    ImageScale scale;
    scale.plane = MeasurementPlane::Typed;
    return valueOf(inPlane, scale);
}

Messages basisOf(const SliceMeasurement& measurement, const VolumeGeometry* scan)
{
    Messages basis;
    if (scan) {
        const Eigen::Vector3d& mm = scan->spacingMm;
        basis.push_back(messages::measureBasisScan(Quantity{mm.x(), 3, "mm"}, Quantity{mm.y(), 3, "mm"},
                                                   Quantity{mm.z(), 3, "mm"}));
    } else {
        basis.push_back(messages::measureBasisScanNotOpen());
    }
    if (measurement.kind == MeasurementKind::Angle) {
        basis.push_back(messages::measureBasisScanAngle());
    }
    return basis;
}

double slicePositionMm(const SliceMeasurement& measurement)
{
    return measurement.pointsInPatient.empty()
               ? 0.0
               : measurement.pointsInPatient.front().dot(axesOf(measurement.plane).normal);
}

Eigen::Vector3d centerOf(const SliceMeasurement& measurement)
{
    if (measurement.pointsInPatient.empty()) {
        return Eigen::Vector3d::Zero();
    }
    Eigen::Vector3d low = measurement.pointsInPatient.front();
    Eigen::Vector3d high = low;
    for (const Eigen::Vector3d& point : measurement.pointsInPatient) {
        low = low.cwiseMin(point);
        high = high.cwiseMax(point);
    }
    return 0.5 * (low + high);
}

}   // namespace angiopose::core
