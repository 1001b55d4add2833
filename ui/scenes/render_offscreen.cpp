#include "ui/scenes/render_offscreen.h"

#include "core/messages/messages.h"
#include "ui/scenes/burn_text.h"
#include "ui/scenes/overlay_painter.h"
#include "ui/scenes/overlay_strokes.h"
#include "ui/scenes/vector_image.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace angiopose::ui {
namespace {

constexpr int maxImagePx = 16384;
constexpr int bandHeight = 1024;
constexpr double lineWidthShare = 0.0022;   // as a fraction of the shorter side

/// Restores the view rectangle and the line width of the scene on destruction.
class ViewRestorer {
public:
    explicit ViewRestorer(OverlayScene& scene)
        : scene_(scene), rect_(scene.viewRect()), lineWidthPx_(scene.lineWidthPx())
    {
    }
    ~ViewRestorer()
    {
        scene_.setViewRect(rect_);
        scene_.setLineWidthPx(lineWidthPx_);
    }
    ViewRestorer(const ViewRestorer&) = delete;
    ViewRestorer& operator=(const ViewRestorer&) = delete;

private:
    OverlayScene& scene_;
    ViewRect rect_;
    double lineWidthPx_;
};

void copyRows(const std::vector<std::uint32_t>& rows, std::size_t pixelCount, std::uint8_t* rgb)
{
    for (std::size_t i = 0; i < pixelCount; ++i) {
        *rgb++ = static_cast<std::uint8_t>(rows[i] >> 16U);
        *rgb++ = static_cast<std::uint8_t>(rows[i] >> 8U);
        *rgb++ = static_cast<std::uint8_t>(rows[i]);
    }
}

/// Draws the view rectangle of the scene in bands, which limits the memory use at any image size.
core::ColorImage drawBands(const OverlayScene& scene, int width, int height)
{
    core::ColorImage image{width, height, {}};
    const auto rowLength = static_cast<std::size_t>(width);
    image.rgb.resize(3 * rowLength * static_cast<std::size_t>(height));
    std::vector<std::uint32_t> band(rowLength * static_cast<std::size_t>(std::min(height, bandHeight)));
    OverlayPainter painter;
    for (int top = 0; top < height; top += bandHeight) {
        const Canvas canvas{band.data(), width, std::min(bandHeight, height - top)};
        painter.drawRows(scene, canvas, top, height);
        copyRows(band, canvas.pixelCount(), image.rgb.data() + 3 * rowLength * static_cast<std::size_t>(top));
    }
    return image;
}

bool isDrawable(int width, int height)
{
    return width >= 1 && height >= 1 && width <= maxImagePx && height <= maxImagePx;
}

void annotate(auto& image, const CornerTexts& texts, double scaleMaximumPx, double scaleMaximumMm)
{
    const BurnSizes sizes = burnSizes(image.width, image.height);
    burnTexts(image, texts, sizes);
    if (scaleMaximumPx > 0.0) {
        burnScale(image, {scaleMaximumPx, scaleMaximumMm, texts.decimalSign, texts.scaleHeading}, sizes);
    }
}

/// Returns the frame at native resolution without vessels, with the DRR if the scene shows one.
core::ColorImage plainFrame(OverlayScene& scene)
{
    const OverlayMode mode = scene.mode();
    const Cutout cutout = scene.cutout();
    scene.setMode(OverlayMode::Hidden);
    scene.setCutout(scene.hasDrr() ? cutout : Cutout{});
    core::ColorImage frame = drawBands(scene, std::max(1, scene.frame().width), std::max(1, scene.frame().height));
    scene.setMode(mode);
    scene.setCutout(cutout);
    return frame;
}

}   // namespace

core::Result<core::ColorImage> renderOffscreen(OverlayScene& scene, int width, int height, const ViewRect& viewRect,
                                               const CornerTexts& texts, double scaleMaximumPx, double scaleMaximumMm)
{
    if (!isDrawable(width, height)) {
        return core::Error(core::messages::imageSizeOutOfRange(maxImagePx));
    }
    const ViewRestorer keeper(scene);
    scene.setLineWidthPx(std::max(1.5, lineWidthShare * std::min(width, height)));
    scene.setViewRect(viewRect);
    core::ColorImage image = drawBands(scene, width, height);
    annotate(image, texts, scaleMaximumPx, scaleMaximumMm);
    return image;
}

core::Result<VectorImage> drawVectors(OverlayScene& scene, int width, int height, const ViewRect& viewRect,
                                      const CornerTexts& texts, double scaleMaximumPx, double scaleMaximumMm)
{
    if (!isDrawable(width, height)) {
        return core::Error(core::messages::imageSizeOutOfRange(maxImagePx));
    }
    const ViewRestorer keeper(scene);
    scene.setViewRect(viewRect);
    scene.setLineWidthPx(std::max(1.5, lineWidthShare * std::min(width, height)));
    VectorImage image{width, height, {}, {}, {}, {}};
    image.backdrops.push_back({plainFrame(scene), 0.0, 1.0 * width});
    image.shapes = visibleShapes(overlayShapes(scene.content(), {viewRect, width, height}), image,
                                 scene.hasDrr() ? Cutout{} : scene.cutout(), viewRect);
    annotate(image, texts, scaleMaximumPx, scaleMaximumMm);
    return image;
}

}   // namespace angiopose::ui
