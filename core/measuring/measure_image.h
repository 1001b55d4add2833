#pragma once

#include "core/imaging/slice_measurement.h"
#include "core/measuring/image_scale.h"
#include "core/support/result.h"

namespace angiopose::core {

/// Value of a measurement and the scale used for it.
struct ImageMeasurementResult {
    Quantity value;   ///< in mm, mm², px, px² or °
    ImageScale scale;
};

/// Returns the minimum number of points for a measurement of this kind.
std::size_t minPoints(MeasurementKind kind);

/// Returns the length along the points, the angle (0°…180°) at the second point, or the area inside the closed outline.
/// Angles depend only on the pixel aspect. The error states why the points are invalid: too few points, non-finite
/// coordinates, an angle with a leg of zero length, or a self-intersecting outline.
Result<Quantity> valueOf(const ImageMeasurement& measurement, const ImageScale& scale);

/// Returns the value of a measurement at the view's scale in the measurement's plane.
Result<ImageMeasurementResult> measureImage(const ImageMeasurement& measurement, const MeasurementContext& context);

/// Returns the label next to the drawing: the value, the plane, and whether the scale is assumed.
Message labelOf(const ImageMeasurementResult& imageResult, MeasurementKind kind);

/// Returns sentences that state what the value is based on, followed by its limitations.
Messages basisOf(const ImageMeasurementResult& imageResult, MeasurementKind kind, const MeasurementContext& context);

/// Returns the length along the points, the angle (0°…180°) at the second point, or the area inside the closed outline,
/// in the plane of the slice: mm, ° or mm². The error states why the points are invalid, as in valueOf for an image.
Result<Quantity> valueOf(const SliceMeasurement& measurement);

/// Returns sentences that state what the value is based on; `scan` is null if no scan is loaded.
Messages basisOf(const SliceMeasurement& measurement, const VolumeGeometry* scan);

/// Returns the position of the slice along its normal, mm.
double slicePositionMm(const SliceMeasurement& measurement);

/// Returns the center of the bounding box of the measurement's points.
Eigen::Vector3d centerOf(const SliceMeasurement& measurement);

}   // namespace angiopose::core
