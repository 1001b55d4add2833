#pragma once

#include "core/imaging/slice_measurement.h"
#include "core/support/result.h"

namespace angiopose::core {

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
