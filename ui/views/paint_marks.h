#pragma once

#include "ui/scenes/image_mark.h"
#include "ui/scenes/label_places.h"
#include "ui/theme/theme.h"

class QPainter;

namespace angiopose::ui {

/// Size of the small parts of marks in a view, widget px.
inline constexpr double markSizePx = 5.0;
inline constexpr double markWidthPx = 1.5;   ///< line width
inline constexpr double markRimWidthPx = 3.6;   ///< line width including the rim on both sides
inline constexpr double markRimOpacity = 0.6;

/// Background of marks.
struct MarkGround : LabelGround {
    Palette tones = palette(ThemeMode::Dark);   ///< images have a black background in every theme
    Color rim = palette(ThemeMode::Dark).canvas;   ///< around lines and letters
    bool hasLines = false;   ///< lines are already drawn (markStrokes): paints only labels
};

/// Draws marks with their labels; `placeOf` gives widget px. Labels avoid the obstacles of the ground, whose size
/// defaults to that of the paint device.
void paintMarks(QPainter& painter, const std::vector<ImageMark>& marks, const MarkPlace& placeOf,
                MarkGround ground = {});

/// Draws a handle at a point that can be dragged.
void paintHandle(QPainter& painter, const Eigen::Vector2d& at, bool isHeld);

}   // namespace angiopose::ui
