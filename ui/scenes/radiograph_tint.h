#pragma once

#include "core/imaging/image2d.h"
#include "ui/scenes/canvas.h"
#include "ui/scenes/row_bands.h"
#include "ui/scenes/view_rect.h"

namespace angiopose::ui {

/// A radiograph of the vessels over the angiogram: a tint in the colour of what is chosen, deepest at the strongest
/// vessel.
class RadiographTint {
public:
    /// `radiograph` covers the whole frame at any resolution, vessels bright on 0; empty: nothing is shown.
    void setRadiograph(const core::ImageF& radiograph);
    bool isEmpty() const { return share_.pixels.empty(); }

    /// A frame's size and the part of it that a canvas shows.
    struct Place {
        int frameWidth = 0, frameHeight = 0;
        ViewRect part;
    };
    void blend(const Place& place, double opacity, Canvas canvas, const Rows& rows) const;

private:
    core::ImageF share_;   ///< of the tint, 0 … 1
};

}   // namespace angiopose::ui