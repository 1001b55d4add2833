#pragma once

#include "ui/scenes/image_mark.h"

class QPainter;

namespace angiopose::ui {

/// Size of the small parts of marks in a view, widget px.
inline constexpr double markSizePx = 5.0;

/// Draws marks with their labels; `placeOf` gives widget px. Labels stay inside the painter's device.
void paintMarks(QPainter& painter, const std::vector<ImageMark>& marks, const MarkPlace& placeOf);

/// A handle where a point can be taken.
void paintHandle(QPainter& painter, const Eigen::Vector2d& at, bool isHeld);

}   // namespace angiopose::ui
