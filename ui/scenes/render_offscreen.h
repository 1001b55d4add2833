#pragma once

#include "core/imaging/image2d.h"
#include "core/support/result.h"
#include "ui/scenes/overlay_scene.h"

#include <string>
#include <vector>

namespace angiopose::ui {

/// Texts burned into an exported overlay, one list per corner.
struct CornerTexts {
    std::vector<std::string> topLeft, topRight, bottomLeft, bottomRight;
    char decimalSign = '.';   ///< decimal separator of the color scale's values
    std::string scaleHeading = {};   ///< heading of that scale; empty: only the unit
};

/// Renders the scene to an image without display or OpenGL; safe on any thread that owns the scene. `viewRect` fills
/// the image. `scaleMaximumPx` > 0 draws the residual scale. Fails only for invalid sizes.
core::Result<core::ColorImage> renderOffscreen(OverlayScene& scene, int width, int height, const ViewRect& viewRect,
                                               const CornerTexts& texts = {}, double scaleMaximumPx = 0.0,
                                               double scaleMaximumMm = 0.0);

struct VectorPicture;

/// Returns the same rendering as vector graphics on the frame (with the DRR, if the scene shows one) at its native
/// resolution.
core::Result<VectorPicture> drawVectors(OverlayScene& scene, int width, int height, const ViewRect& viewRect,
                                        const CornerTexts& texts = {}, double scaleMaximumPx = 0.0,
                                        double scaleMaximumMm = 0.0);

}   // namespace angiopose::ui