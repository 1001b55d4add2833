#pragma once

#include "ui/scenes/overlay_scene.h"
#include "ui/scenes/stroke_mesh.h"

#include <cstdint>
#include <utility>
#include <vector>

namespace angiopose::ui {

/// Draws the angiogram and its overlay on the CPU, without OpenGL or Qt, with identical pixels in windows (without a
/// graphics card), in exported PNG files and in tests. Caches the resampled angiogram while only the tree moves.
class OverlayPainter {
public:
    /// Draws the view rectangle of the scene over the whole canvas.
    void draw(const OverlayScene& scene, Canvas canvas) { drawRows(scene, canvas, 0, canvas.height); }

    /// Draws a band of an image with `rowCount` rows; `firstRow` is the top row of the canvas.
    void drawRows(const OverlayScene& scene, Canvas canvas, int firstRow, int rowCount);

private:
    /// Cached angiogram at canvas resolution, valid until the visible part, the size or the gray mapping changes.
    struct Backdrop {
        std::vector<std::uint32_t> pixels;
        ViewRect rect;
        std::pair<int, int> size{0, 0};
        Interpolation interpolation = Interpolation::Smooth;
        std::uint64_t frameRevision = 0;
    };
    /// Cached overlay triangles for one view and size.
    struct Strokes {
        StrokeMesh mesh;
        std::uint64_t revision = 0;
        ViewRect rect;
        std::pair<int, int> size{0, 0};
    };
    const std::vector<std::uint32_t>& backdropOf(const OverlayContent& content, const ViewRect& part, Canvas canvas);
    const StrokeMesh& strokesOf(const OverlayContent& content, int width, int height);

    Backdrop backdrop_;
    Strokes strokes_;
};

}   // namespace angiopose::ui
