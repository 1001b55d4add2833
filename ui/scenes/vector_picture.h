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

/// Pixels below the vectors, stretched over a part of the picture's width and all of its height.
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

/// A line of text with its start, or with TextAlign::Right its end, on the baseline.
struct VectorText {
    std::string text;   ///< UTF-8
    Eigen::Vector2d at;
    TextAlign align = TextAlign::Left;
    int sizePx = 14;
    Color tone = palette(ThemeMode::Dark).textStrong;
};

/// What an exported picture shows, as shapes instead of pixels, lowest first: backdrops, shapes, fills, texts. In px of
/// the same picture in pixels; shapes with y up as everywhere, all else with y down.
struct VectorPicture {
    int width = 0;
    int height = 0;
    std::vector<VectorBackdrop> backdrops;
    std::vector<StrokeShape> shapes;
    std::vector<VectorFill> fills;
    std::vector<VectorText> texts;
};

/// The shapes' parts inside the picture and outside the cutout, which is given as in the image that `part` shows, with
/// the cutout's rim.
std::vector<StrokeShape> visibleShapes(const std::vector<StrokeShape>& shapes, const VectorPicture& picture,
                                       const Cutout& cutout, const ViewRect& part);

/// Two pictures of one height with a gap between them.
VectorPicture besideEachOther(VectorPicture left, const VectorPicture& right, int gap);

}   // namespace angiopose::ui
