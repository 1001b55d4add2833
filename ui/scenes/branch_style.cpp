#include "ui/scenes/branch_style.h"

namespace angiopose::ui {

BranchStyle branchStyle(int branchId, const BranchMarks& marks, const Palette& tones)
{
    const BranchColors colors = branchColors(tones);
    BranchStyle style{.color = colors.plain};
    if (marks.excluded.contains(branchId)) {
        style = {
            .color = tones.label, .widthFactor = 0.8, .opacity = 0.75, .pattern = LinePattern::Dashed, .zOrder = -1};
    } else if (marks.auxiliary.contains(branchId)) {
        style = {.color = colors.auxiliary, .widthFactor = 1.15, .hasEndDots = true, .zOrder = 1};
    }
    if (marks.selected.contains(branchId)) {
        style.color = colors.selected;
        style.widthFactor = 1.6;
        style.opacity = 1.0;
        style.glow = Glow::Strong;
        style.zOrder = 2;
    }
    if (marks.hovered == branchId) {
        style.color = mixed(style.color, tones.textStrong, 0.5);
        style.widthFactor = 1.6;
        style.opacity = 1.0;
        style.glow = style.glow == Glow::None ? Glow::Faint : style.glow;
        style.zOrder = 3;
    }
    return style;
}

}   // namespace angiopose::ui
