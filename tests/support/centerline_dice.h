#pragma once

#include "core/imaging/image2d.h"
#include "core/vessel/centerline2d.h"

namespace angiopose::test {

/// Centerline Dice (Shit et al. 2021): agreement of curves with a drawn vessel mask, each value 0…1.
struct CenterlineDice {
    double precision = 0.0;   ///< share of traced pixels inside the mask
    double sensitivity = 0.0;   ///< share of the mask's skeleton inside the traced vessels, drawn with their radii

    double dice() const;
};

CenterlineDice centerlineDice(const core::Centerline2d& traced, const core::Mask2d& truth);

/// Pixels of a grayscale image above half of white.
core::Mask2d whitePixels(const core::ImageF& picture);

}   // namespace angiopose::test
