#pragma once

#include "ui/scenes/cutout.h"
#include "ui/scenes/view_rect.h"

namespace angiopose::ui {

/// Visible part of the image and size of the view. Left and right are exchanged when seen from the source.
struct PicturePlace {
    ViewRect rect;
    int width = 1;   ///< device px
    int height = 1;
    bool isMirrored = false;

    double scale() const { return width / rect.width(); }   ///< device px per image px

    /// Visible part ordered by the view's left and right edges.
    ViewRect seen() const { return isMirrored ? ViewRect{rect.right, rect.left, rect.top, rect.bottom} : rect; }
};

}   // namespace angiopose::ui
