#pragma once

#include "core/imaging/image2d.h"
#include "ui/scenes/canvas.h"
#include "ui/scenes/revision.h"
#include "ui/scenes/row_bands.h"
#include "ui/scenes/view_rect.h"

#include <cstdint>

namespace angiopose::ui {

inline constexpr double maxTintOpacity = 0.75;   ///< the angiogram stays visible through the densest vessel

/// Tints the angiogram with the DRR of the vessels in the accent color, most strongly at the densest vessel.
class DrrTint {
public:
    /// Sets the DRR, which covers the whole frame at any resolution, with bright vessels on 0; empty for no tint.
    void setDrr(const core::ImageF& drr);
    const core::ImageF& share() const { return strength_; }   ///< strength of the tint at each pixel, 0…1
    std::uint64_t revision() const { return revision_; }   ///< changes with the DRR
    bool isEmpty() const { return strength_.pixels.empty(); }

    /// Frame size and the part of the frame that a canvas shows.
    struct Place {
        int frameWidth = 0, frameHeight = 0;
        ViewRect part;
    };
    void blend(const Place& place, double opacity, Canvas canvas, const Rows& rows) const;

private:
    core::ImageF strength_;
    std::uint64_t revision_ = nextRevision();
};

}   // namespace angiopose::ui
