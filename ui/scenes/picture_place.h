#pragma once

#include "ui/scenes/cutout.h"
#include "ui/scenes/view_rect.h"

namespace angiopose::ui {

/// What of the image a picture shows, and how large the picture is. Seen from the source, left and right are exchanged.
struct PicturePlace {
    ViewRect rect;
    int width = 1;   ///< device px
    int height = 1;
    bool isMirrored = false;

    double scale() const { return width / rect.width(); }   ///< device px per image px

    /// The part as the picture's left and right edges show it.
    ViewRect seen() const { return isMirrored ? ViewRect{rect.right, rect.left, rect.top, rect.bottom} : rect; }
};

}   // namespace angiopose::ui
