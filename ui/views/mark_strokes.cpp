#include "ui/views/mark_strokes.h"

#include "ui/views/paint_marks.h"

#include <algorithm>

namespace angiopose::ui {
namespace {

constexpr double beyondPicturePx = 64.0;   ///< clipping margin, wider than any stroke

StrokeLine inOneTone(const PixelLine& line, const MarkPicture& picture, const Color& tone)
{
    StrokeLine stroke;
    stroke.reserve(line.size());
    for (const Eigen::Vector2d& at : line) {
        stroke.push_back({{picture.pixelRatio * at.x(), picture.sizePx.y() - picture.pixelRatio * at.y()}, tone});
    }
    return stroke;
}

StrokeLine recolored(StrokeLine stroke, const Color& tone)
{
    for (StrokePoint& point : stroke) {
        point.color = tone;
    }
    return stroke;
}

}   // namespace

StrokeMesh markStrokes(const std::vector<ImageMark>& marks, const MarkPlace& placeOf, const MarkPicture& picture,
                       const Palette& tones, const Color& rim)
{
    const Eigen::Vector2d margin(beyondPicturePx, beyondPicturePx);
    StrokeMesh mesh;
    for (const ImageMark& mark : marks) {
        for (const PixelLine& line : linesOf(mark, placeOf, markSizePx)) {
            const StrokeLine whole = inOneTone(line, picture, toneOf(mark, tones));
            for (const StrokeLine& part : clipped(whole, -margin, picture.sizePx + margin)) {
                addLine(mesh, recolored(part, rim), {markRimWidthPx * picture.pixelRatio, markRimOpacity});
                addLine(mesh, part, {markWidthPx * picture.pixelRatio, 1.0});
            }
        }
    }
    return mesh;
}

}   // namespace angiopose::ui
