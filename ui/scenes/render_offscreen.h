#pragma once

#include "core/imaging/image2d.h"
#include "core/support/result.h"
#include "ui/scenes/overlay_scene.h"

#include <string>
#include <vector>

namespace angiopose::ui {

/// Text burned into the corners of an exported overlay, a list of lines for each corner.
struct CornerTexts {
    std::vector<std::string> topLeft, topRight, bottomLeft, bottomRight;
    char decimalSign = '.';   ///< decimal separator in the labels of the color scale
    std::string scaleHeading = {};   ///< heading of the color scale; if empty, only the unit is shown
};

/// Renders the scene to an image without display or OpenGL; the thread that owns the scene may call it. The image shows
/// `viewRect`. Draws the residual scale if `scaleMaximumPx` > 0. Fails only for invalid sizes.
core::Result<core::ColorImage> renderOffscreen(OverlayScene& scene, int width, int height, const ViewRect& viewRect,
                                               const CornerTexts& texts = {}, double scaleMaximumPx = 0.0,
                                               double scaleMaximumMm = 0.0);

struct VectorImage;

/// Returns the image of `renderOffscreen` as vector graphics on top of the frame at native resolution, including any
/// DRR that the scene shows.
core::Result<VectorImage> drawVectors(OverlayScene& scene, int width, int height, const ViewRect& viewRect,
                                      const CornerTexts& texts = {}, double scaleMaximumPx = 0.0,
                                      double scaleMaximumMm = 0.0);

}   // namespace angiopose::ui
