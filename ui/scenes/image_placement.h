#pragma once

#include "ui/scenes/cutout.h"
#include "ui/scenes/view_rect.h"

namespace angiopose::ui {

/// Visible part of the image and size of the view. `isMirrored` swaps left and right, as viewed from the X-ray source.
struct ImagePlacement {
    ViewRect rect;
    int width = 1;   ///< width of the view, device px
    int height = 1;
    bool isMirrored = false;

    double scale() const { return width / rect.width(); }   ///< device px per image px

    /// Returns the visible part with `left` and `right` at the left and right edges of the view.
    ViewRect displayedRect() const
    {
        return isMirrored ? ViewRect{rect.right, rect.left, rect.top, rect.bottom} : rect;
    }
};

}   // namespace angiopose::ui
