#include "ui/scenes/render_offscreen.h"

#include "ui/scenes/burn_text.h"
#include "ui/scenes/egl_window.h"

#include <vtkNew.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <optional>
#include <thread>
#include <utility>

namespace ui {
namespace {

constexpr int largestPicturePx = 16384;
constexpr int largestTilePx = 2048;   // keeps video memory small at any picture size
constexpr double lineWidthShare = 0.0022;   // of the shorter side

/// Puts the scene's view back as it was.
class ViewKeeper {
public:
    explicit ViewKeeper(OverlayScene& scene) : scene_(scene), rect_(scene.viewRect()), lineWidthPx_(scene.lineWidthPx())
    {
    }
    ~ViewKeeper()
    {
        scene_.setViewRect(rect_);
        scene_.setLineWidthPx(lineWidthPx_);
    }
    ViewKeeper(const ViewKeeper&) = delete;
    ViewKeeper& operator=(const ViewKeeper&) = delete;

private:
    OverlayScene& scene_;
    ViewRect rect_;
    double lineWidthPx_;
};

struct Tile {
    int left, top, width, height;
};

std::vector<Tile> tilesOf(int width, int height)
{
    std::vector<Tile> tiles;
    for (int top = 0; top < height; top += largestTilePx) {
        for (int left = 0; left < width; left += largestTilePx) {
            tiles.push_back({left, top, std::min(largestTilePx, width - left), std::min(largestTilePx, height - top)});
        }
    }
    return tiles;
}

ViewRect partOf(const ViewRect& rect, const Tile& tile, const core::ColorImage& picture)
{
    const double across = (rect.right - rect.left) / picture.width;
    const double down = (rect.bottom - rect.top) / picture.height;
    return {rect.left + across * tile.left, rect.left + across * (tile.left + tile.width), rect.top + down * tile.top,
            rect.top + down * (tile.top + tile.height)};
}

void copyTile(EglWindow& window, const Tile& tile, core::ColorImage& picture)
{
    vtkNew<vtkUnsignedCharArray> pixels;
    window.GetPixelData(0, 0, tile.width - 1, tile.height - 1, 0, pixels, 0);
    const auto rowBytes = static_cast<std::size_t>(tile.width) * 3;
    for (int row = 0; row < tile.height; ++row) {   // OpenGL counts rows from the bottom
        const std::uint8_t* from = pixels->GetPointer(0) + static_cast<std::size_t>(tile.height - 1 - row) * rowBytes;
        const std::size_t to = static_cast<std::size_t>(tile.top + row) * static_cast<std::size_t>(picture.width) +
                               static_cast<std::size_t>(tile.left);
        std::copy(from, from + rowBytes, picture.rgb.begin() + static_cast<std::ptrdiff_t>(3 * to));
    }
}

/// What the scene shows of `viewRect`, tile by tile; nothing when there is no OpenGL.
std::optional<core::ColorImage> renderTiles(OverlayScene& scene, int width, int height, const ViewRect& viewRect)
{
    const vtkSmartPointer<EglWindow> window = EglWindow::create();
    if (!window) {
        return std::nullopt;
    }
    core::ColorImage picture{width, height, {}};
    picture.rgb.resize(3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    scene.attachTo(window);
    for (const Tile& tile : tilesOf(width, height)) {
        window->SetSize(tile.width, tile.height);
        scene.setViewRect(partOf(viewRect, tile, picture));
        window->takeOverState();
        window->Render();
        copyTile(*window, tile, picture);
    }
    scene.detachFrom(window);
    return picture;
}

}   // namespace

core::Result<core::ColorImage> renderOffscreen(OverlayScene& scene, int width, int height, const ViewRect& viewRect,
                                               const CornerTexts& texts, double scaleMaximumPx, double scaleMaximumMm)
{
    if (width < 1 || height < 1 || width > largestPicturePx || height > largestPicturePx) {
        return core::Error{"The picture must be 1 to " + std::to_string(largestPicturePx) +
                           " px wide and high; choose another size."};
    }
    const ViewKeeper keeper(scene);
    scene.setLineWidthPx(std::max(1.5, lineWidthShare * std::min(width, height)));
    // A thread holds one OpenGL context, and the window's own (GLX) bars EGL from its thread: draw in a fresh one.
    std::optional<core::ColorImage> picture;
    std::thread([&] { picture = renderTiles(scene, width, height, viewRect); }).join();
    if (!picture) {
        return core::Error{
            "The overlay cannot be drawn: OpenGL 3.2 through EGL is not available. Install libegl1 and "
            "libgl1-mesa-dri."};
    }
    const BurnSizes sizes = burnSizes(width, height);
    burnTexts(*picture, texts, sizes);
    if (scaleMaximumPx > 0.0) {
        burnScale(*picture, scaleMaximumPx, scaleMaximumMm, sizes);
    }
    return std::move(*picture);
}

}   // namespace ui
