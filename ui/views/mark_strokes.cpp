#include "ui/views/mark_strokes.h"

#include "ui/views/paint_marks.h"

namespace angiopose::ui {
namespace {

constexpr double beyondPicturePx = 64.0;   ///< clipping margin, wider than any stroke

StrokeLine inOneColor(const PixelLine& line, const MarkCanvas& image, const Color& tone)
{
    StrokeLine stroke;
    stroke.reserve(line.size());
    for (const Eigen::Vector2d& at : line) {
        stroke.push_back({{image.pixelRatio * at.x(), image.sizePx.y() - image.pixelRatio * at.y()}, tone});
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

StrokeMesh markStrokes(const std::vector<ImageMark>& marks, const PixelMapping& positionOf, const MarkCanvas& image,
                       const Palette& colors, const Color& rim)
{
    const Eigen::Vector2d margin(beyondPicturePx, beyondPicturePx);
    StrokeMesh mesh;
    for (const ImageMark& mark : marks) {
        for (const PixelLine& line : markLines(mark, positionOf, markSizePx)) {
            const StrokeLine whole = inOneColor(line, image, markColor(mark, colors));
            for (const StrokeLine& part : clipLine(whole, -margin, image.sizePx + margin)) {
                addLine(mesh, recolored(part, rim), {markRimWidthPx * image.pixelRatio, markRimOpacity});
                addLine(mesh, part, {markWidthPx * image.pixelRatio, 1.0});
            }
        }
    }
    return mesh;
}

}   // namespace angiopose::ui
