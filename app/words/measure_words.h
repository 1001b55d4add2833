#pragma once

#include "app/texts/image_marks.h"
#include "core/imaging/slice_measurement.h"
#include "core/measuring/image_scale.h"
#include "ui/panels/measure_panel.h"
#include "ui/scenes/image_mark.h"

namespace angiopose::app {

/// A measurement as the window lists it.
ui::MeasureRow measureRow(const core::ImageMeasurement& measurement, const core::MeasuredView& seen);

/// Likewise one of a slice; `scan` may be null. And its value alone.
ui::MeasureRow sliceRow(const core::SliceMeasurement& measurement, const core::VolumeGeometry* scan);
QString sliceLabel(const core::SliceMeasurement& measurement);

/// What a plane of a view rests on, or why nothing can be measured in it.
QString planeBasis(core::MeasurementPlane plane, const core::MeasuredView& seen);

/// Its value alone, as it is drawn beside it.
QString measureLabel(const core::ImageMeasurement& measurement, const core::MeasuredView& seen);

/// The marks of a frame in the language of the window.
std::vector<ui::ImageMark> windowMarks(const core::MeasuredView& seen, int frame);
std::vector<ui::ImageMark> windowPlacedMarks(const PlacedView& placed);

}   // namespace angiopose::app
