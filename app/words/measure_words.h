#pragma once

#include "app/texts/image_marks.h"
#include "core/imaging/slice_measurement.h"
#include "core/measuring/image_scale.h"
#include "ui/panels/measure_panel.h"
#include "ui/scenes/image_mark.h"

namespace angiopose::app {

/// Returns the list row of an image measurement.
ui::MeasureRow measureRow(const core::ImageMeasurement& measurement, const core::MeasurementContext& context);

/// Return the list row of a slice measurement, and its value alone; `scan` may be null.
ui::MeasureRow sliceRow(const core::SliceMeasurement& measurement, const core::VolumeGeometry* scan);
QString sliceLabel(const core::SliceMeasurement& measurement);

/// Returns the basis of the scale in a plane of a view, or the reason why nothing can be measured in that plane.
QString planeBasis(core::MeasurementPlane plane, const core::MeasurementContext& context);

/// Returns the value of a measurement as drawn next to it.
QString measureLabel(const core::ImageMeasurement& measurement, const core::MeasurementContext& context);

/// Return the marks of a frame in the UI language.
std::vector<ui::ImageMark> windowMarks(const core::MeasurementContext& context, int frame);
std::vector<ui::ImageMark> windowPlacedMarks(const MarkedView& placed);

}   // namespace angiopose::app
