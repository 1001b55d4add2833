#pragma once

#include "core/imaging/slice_measurement.h"
#include "core/measuring/image_scale.h"
#include "core/support/result.h"

namespace angiopose::core {

/// A measurement's value, and the scale that it was found with.
struct MeasuredImage {
    Quantity value;   ///< mm, mm², px, px² or °
    ImageScale scale;
};

/// The fewest points of a measurement.
std::size_t minPoints(MeasurementKind kind);

/// Length along the points; the angle (0°…180°) at the second point; the area inside the closed outline. Angles need
/// the shape of a pixel only. Fails, saying why, on points that do not make such a thing: too few, not finite, an angle
/// without legs, an outline that crosses itself.
Result<Quantity> valueOf(const ImageMeasurement& measurement, const ImageScale& scale);

/// The same with the scale that the view has in the measurement's plane.
Result<MeasuredImage> measureImage(const ImageMeasurement& measurement, const MeasuredView& seen);

/// What stands beside the drawing: the value, where it holds, and whether its scale is assumed.
Message labelOf(const MeasuredImage& measured, MeasurementKind kind);

/// What the value rests on, and what speaks against it: a sentence each, the basis first.
Messages basisOf(const MeasuredImage& measured, MeasurementKind kind, const MeasuredView& seen);

/// Length along the points, the angle (0°…180°) at the second point, or the area inside the closed outline, in the
/// plane of the slice: mm, ° or mm². Fails, saying why, on points that do not make such a thing, as valueOf of an image
/// does.
Result<Quantity> valueOf(const SliceMeasurement& measurement);

/// What the value rests on, a sentence each; `scan` may be null: it is not open.
Messages basisOf(const SliceMeasurement& measurement, const VolumeGeometry* scan);

/// Where the slice stands: along its normal, mm.
double sliceAtMm(const SliceMeasurement& measurement);

/// The middle of the box around its points.
Eigen::Vector3d middleOf(const SliceMeasurement& measurement);

}   // namespace angiopose::core
