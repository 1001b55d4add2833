#pragma once

#include "ui/scenes/overlay_content.h"
#include "ui/theme/theme.h"

namespace angiopose::ui {

enum class LinePattern { Solid, Dashed };
enum class Glow { None, Faint, Strong };

/// Style of one branch. Color is never the only distinction: excluded branches are dashed, auxiliary branches have dots
/// at their ends, and hovered or selected branches are thicker and glow.
struct BranchStyle {
    Color color;
    double widthFactor = 1.0;
    double opacity = 1.0;
    LinePattern pattern = LinePattern::Solid;
    Glow glow = Glow::None;
    bool hasEndDots = false;
    int zOrder = 0;   ///< drawing order: higher values are drawn on top
};

/// Returns the style of a branch on a background with the palette `colors`; images have a black background in every
/// theme.
BranchStyle branchStyle(int branchId, const BranchMarks& marks, const Palette& colors = palette(ThemeMode::Dark));

}   // namespace angiopose::ui
