#pragma once

#include "ui/slices/slice_annotations.h"

namespace angiopose::ui {

/// Draws the measurements of the displayed plane: with values in their own slice, and faintly in neighboring slices.
void paintMeasurements(QPainter& painter, const SliceOverlay& overlay);

/// Draws the intersection of a ring with the slice: the parts inside the slice and the cutting line.
void paintRing(QPainter& painter, const SliceOverlay& overlay, const std::vector<Eigen::Vector3d>& ring);

/// Wraps a caption, whose parts are separated by " · ", into lines that fit the width.
QStringList captionLines(const QString& caption, int widthPx);

/// Returns whether the grid shows the slice of the measurement.
bool isInSlice(const core::SliceMeasurement& measurement, core::BodyPlane plane, const core::SliceGrid& grid);

}   // namespace angiopose::ui
