#pragma once

#include "ui/slices/slice_annotations.h"

namespace angiopose::ui {

/// What was measured in the slices of this plane: in its own slice with the value, faint in its neighbours.
void paintMeasurements(QPainter& painter, const SliceOverlay& overlay);

/// Where a ring goes through the slice: its pieces within the slice, and the line on which it cuts it.
void paintRing(QPainter& painter, const SliceOverlay& overlay, const std::vector<Eigen::Vector3d>& ring);

/// Of a sentence whose parts are set off by dots, as many lines as fit the width.
QStringList captionLines(const QString& caption, int widthPx);

/// Its own slice is shown.
bool isInSlice(const core::SliceMeasurement& measurement, core::BodyPlane plane, const core::SliceGrid& grid);

}   // namespace angiopose::ui
