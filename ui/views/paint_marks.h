#pragma once

#include "ui/scenes/image_mark.h"
#include "ui/scenes/label_places.h"
#include "ui/theme/theme.h"

class QPainter;

namespace angiopose::ui {

/// Size of bars, circles, crosses and arrowheads of marks in a view, widget px.
inline constexpr double markSizePx = 5.0;
inline constexpr double markWidthPx = 1.5;   ///< line width
inline constexpr double markRimWidthPx = 3.6;   ///< width including the outline on both sides
inline constexpr double markRimOpacity = 0.6;

/// Background on which marks are drawn, with the obstacles for their labels.
struct MarkBackground : LabelObstacles {
    Palette colors = palette(ThemeMode::Dark);   ///< by default that of images, which is black in every theme
    Color rim = palette(ThemeMode::Dark).canvas;   ///< outline of lines and letters
    bool hasLines = false;   ///< if true, markStrokes has drawn the lines; only labels are painted
};

/// Draws marks with their labels; `positionOf` returns widget px. Labels avoid the obstacles in `background`, whose
/// size is by default that of the paint device.
void paintMarks(QPainter& painter, const std::vector<ImageMark>& marks, const PixelMapping& positionOf,
                MarkBackground background = {});

/// Draws the handle of a draggable point.
void paintHandle(QPainter& painter, const Eigen::Vector2d& at, bool isHeld);

}   // namespace angiopose::ui
