#include "ui/scenes/overlay_painter.h"

#include "ui/scenes/fill_strokes.h"
#include "ui/scenes/overlay_strokes.h"

#include <algorithm>

namespace angiopose::ui {

const std::vector<std::uint32_t>& OverlayPainter::backdropOf(const OverlayContent& content, const ViewRect& part,
                                                             Canvas canvas)
{
    const GrayFrame& frame = content.frame;
    const std::pair size{canvas.width, canvas.height};
    if (backdrop_.frameRevision == frame.revision() && backdrop_.rect == part && backdrop_.size == size &&
        backdrop_.interpolation == content.interpolation) {
        return backdrop_.pixels;
    }
    backdrop_.frameRevision = frame.revision();
    backdrop_.rect = part;
    backdrop_.size = size;
    backdrop_.interpolation = content.interpolation;
    const Color& background = palette(ThemeMode::Dark).canvas;
    backdrop_.pixels.assign(canvas.pixelCount(), packColor(background));
    if (frame.width() > 0 && frame.height() > 0) {
        resampleFrame(frame.gray(), part, content.interpolation, background,
                      {backdrop_.pixels.data(), canvas.width, canvas.height});
    }
    return backdrop_.pixels;
}

const StrokeMesh& OverlayPainter::strokesOf(const OverlayContent& content, int width, int height)
{
    const std::pair size{width, height};
    if (strokes_.revision != content.revision || !(strokes_.rect == content.viewRect) || strokes_.size != size) {
        strokes_ = {overlayStrokes(content, {content.viewRect, width, height}), content.revision, content.viewRect,
                    size};
    }
    return strokes_.mesh;
}

void OverlayPainter::drawRows(const OverlayScene& scene, Canvas canvas, int firstRow, int rowCount)
{
    const OverlayContent& content = scene.content();
    const double rowHeight = content.viewRect.height() / rowCount;
    ViewRect part = content.viewRect;
    part.top += rowHeight * firstRow;
    part.bottom = part.top + rowHeight * canvas.height;
    const std::vector<std::uint32_t>& bare = backdropOf(content, part, canvas);
    const StrokeMesh& mesh = strokesOf(content, canvas.width, rowCount);
    forEachBand(canvas.height, [&](const Rows& rows) {
        std::copy(bare.data() + (canvas.row(rows.from) - canvas.pixels),
                  bare.data() + (canvas.row(rows.to) - canvas.pixels), canvas.row(rows.from));
        if (!content.isOverlayHidden) {
            content.drr.blend({content.frame.width(), content.frame.height(), part}, content.opacity, canvas, rows);
        }
        fillStrokes(mesh, rowCount - firstRow, canvas, rows);
        applyCutout(content.cutout, part, bare, canvas, rows);
    });
}

}   // namespace angiopose::ui
