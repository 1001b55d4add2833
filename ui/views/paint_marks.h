#pragma once

#include "ui/scenes/image_mark.h"
#include "ui/scenes/label_places.h"
#include "ui/theme/theme.h"

class QPainter;

namespace angiopose::ui {

/// Size of the small parts of marks in a view, widget px.
inline constexpr double markSizePx = 5.0;
inline constexpr double markWidthPx = 1.5;   ///< of their lines
inline constexpr double markRimWidthPx = 3.6;   ///< with the rim on both sides
inline constexpr double markRimOpacity = 0.6;

/// What marks are drawn on.
struct MarkGround : LabelGround {
    Palette tones = palette(ThemeMode::Dark);   ///< images lie on black in every theme
    Color rim = palette(ThemeMode::Dark).canvas;   ///< around lines and letters
    bool hasLines = false;   ///< they are there already (markStrokes): labels alone are drawn
};

/// Draws marks with their labels; `placeOf` gives widget px. Labels keep clear of what the ground has, whose size
/// follows from the painter's device where it has none.
void paintMarks(QPainter& painter, const std::vector<ImageMark>& marks, const MarkPlace& placeOf,
                MarkGround ground = {});

/// A handle where a point can be taken.
void paintHandle(QPainter& painter, const Eigen::Vector2d& at, bool isHeld);

}   // namespace angiopose::ui
