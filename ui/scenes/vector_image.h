#pragma once

#include "core/imaging/image2d.h"
#include "ui/scenes/cutout.h"
#include "ui/scenes/stroke_mesh.h"
#include "ui/scenes/text_mask.h"
#include "ui/scenes/view_rect.h"
#include "ui/theme/theme.h"

#include <string>
#include <vector>

namespace angiopose::ui {

/// Raster background below the vector shapes, stretched to the full image height and to `width` from `left`.
struct VectorBackdrop {
    core::ColorImage image;
    double left = 0.0;
    double width = 0.0;
};

struct VectorFill {
    ViewRect rect;
    Color color;
    double opacity = 1.0;
};

/// Line of text; `at` is the point on the baseline at which the text starts, or ends with TextAlign::Right.
struct VectorText {
    std::string text;   ///< UTF-8
    Eigen::Vector2d at;
    TextAlign align = TextAlign::Left;
    int sizePx = 14;
    Color tone = palette(ThemeMode::Dark).textStrong;
};

/// Exported image as vector graphics, in drawing order: backdrops, shapes, fills, text. Coordinates are px of the
/// corresponding raster image, with y up in shapes and y down elsewhere.
struct VectorImage {
    int width = 0;
    int height = 0;
    std::vector<VectorBackdrop> backdrops;
    std::vector<StrokeShape> shapes;
    std::vector<VectorFill> fills;
    std::vector<VectorText> texts;
};

/// Returns the parts of the shapes that lie inside the image and outside the cutout, plus the edge of the cutout. The
/// cutout is given in px of the angiogram, of which the image shows `part`.
std::vector<StrokeShape> visibleShapes(const std::vector<StrokeShape>& shapes, const VectorImage& picture,
                                       const Cutout& cutout, const ViewRect& part);

/// Joins two images of equal height side by side with a gap.
VectorImage joinSideBySide(VectorImage left, const VectorImage& right, int gap);

}   // namespace angiopose::ui
