#pragma once

#include "ui/scenes/overlay_content.h"
#include "ui/theme/theme.h"

namespace angiopose::ui {

enum class LinePattern { Solid, Dashed };
enum class Glow { None, Faint, Strong };

/// Look of one branch. No meaning hangs on colour alone: excluded is dashed, auxiliary has dots at its ends, hovered
/// and selected are thicker and glow.
struct BranchStyle {
    Color color;
    double widthFactor = 1.0;
    double opacity = 1.0;
    LinePattern pattern = LinePattern::Solid;
    Glow glow = Glow::None;
    bool hasEndDots = false;
    int rank = 0;   ///< higher ones are drawn later, on top
};

/// `tones` are those of the ground the branch lies on; images lie on black in every theme.
BranchStyle branchStyle(int branchId, const BranchMarks& marks, const Palette& tones = palette(ThemeMode::Dark));

}   // namespace angiopose::ui