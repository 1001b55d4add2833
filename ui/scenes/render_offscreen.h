#pragma once

#include "core/imaging/image2d.h"
#include "core/support/result.h"
#include "ui/scenes/overlay_scene.h"

#include <string>
#include <vector>

namespace angiopose::ui {

/// Text burned into an exported overlay, one list per corner.
struct CornerTexts {
    std::vector<std::string> topLeft, topRight, bottomLeft, bottomRight;
    char decimalSign = '.';   ///< of the numbers at the scale of colours
    std::string scaleHeading = {};   ///< above that scale; empty: the unit alone
};

/// Renders the scene into a picture, without display or OpenGL; safe on any thread that owns the scene. `viewRect`
/// fills the picture. `scaleMaximumPx` > 0 draws the residual scale. Fails only on impossible sizes.
core::Result<core::ColorImage> renderOffscreen(OverlayScene& scene, int width, int height, const ViewRect& viewRect,
                                               const CornerTexts& texts = {}, double scaleMaximumPx = 0.0,
                                               double scaleMaximumMm = 0.0);

struct VectorPicture;

/// The same as vectors, on the frame (with the radiograph, where the scene shows one) at its own resolution.
core::Result<VectorPicture> drawVectors(OverlayScene& scene, int width, int height, const ViewRect& viewRect,
                                        const CornerTexts& texts = {}, double scaleMaximumPx = 0.0,
                                        double scaleMaximumMm = 0.0);

}   // namespace angiopose::ui