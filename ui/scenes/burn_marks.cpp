#include "ui/scenes/burn_marks.h"

#include "ui/scenes/fill_strokes.h"
#include "ui/scenes/label_places.h"
#include "ui/theme/theme.h"

#include <algorithm>
#include <cstdint>
#include <iterator>

namespace angiopose::ui {
namespace {

constexpr int markBandHeight = 1024;

/// Adds each line twice: a wide dark outline, then the line in its own color.
void addMarkLine(StrokeMesh& mesh, const PixelLine& line, int heightPx, const Color& tone, const BurnSizes& sizes)
{
    const double widthPx = std::max(1.2, sizes.textPx / 9.0);
    const auto stroke = [&](const Color& color, const Pen& pen) {
        StrokeLine points;
        for (const Eigen::Vector2d& at : line) {
            points.push_back({{at.x(), heightPx - at.y()}, color});
        }
        addLine(mesh, points, pen);
    };
    stroke(palette(ThemeMode::Dark).canvas, {.widthPx = 2.4 * widthPx, .opacity = 0.6});
    stroke(tone, {.widthPx = widthPx});
}

void addMarks(StrokeMesh& mesh, const std::vector<ImageMark>& marks, const PixelMapping& positionOf, int heightPx,
              const BurnSizes& sizes)
{
    for (const ImageMark& mark : marks) {
        for (const PixelLine& line : markLines(mark, positionOf, 0.4 * sizes.textPx)) {
            addMarkLine(mesh, line, heightPx, markColor(mark, palette(ThemeMode::Dark)), sizes);
        }
    }
}

/// Returns the mapping from angiogram px to px of an exported image that shows `part`.
PixelMapping placeIn(const auto& image, const ViewRect& part)
{
    const Eigen::Vector2d scale(image.width / part.width(), image.height / part.height());
    return [scale, corner = Eigen::Vector2d(part.left, part.top)](const Eigen::Vector2d& pixel) -> Eigen::Vector2d {
        return (pixel - corner).cwiseProduct(scale);
    };
}

/// Returns the image corners that are reserved for corner text.
std::vector<ViewRect> cornersOf(const auto& image, const BurnSizes& sizes)
{
    const double wide = 0.3 * image.width;
    const double high = 4.5 * 1.4 * sizes.textPx + sizes.marginPx;
    return {{0.0, wide, 0.0, high},
            {image.width - wide, 1.0 * image.width, 0.0, high},
            {0.0, wide, image.height - high, 1.0 * image.height},
            {image.width - wide, 1.0 * image.width, image.height - high, 1.0 * image.height}};
}

void addLabels(auto& image, const std::vector<ImageMark>& marks, const PixelMapping& positionOf, const BurnSizes& sizes,
               const std::vector<Eigen::Vector2d>& avoided)
{
    LabelObstacles obstacles{1.0 * image.width, 1.0 * image.height, cornersOf(image, sizes), {}};
    for (const Eigen::Vector2d& pixel : avoided) {
        obstacles.avoided.push_back(positionOf(pixel));
    }
    for (const ImageMark& mark : marks) {
        const double sizePx = 0.4 * sizes.textPx;
        std::ranges::copy(pointsAlong(markLines(mark, positionOf, sizePx), sizePx),
                          std::back_inserter(obstacles.avoided));
    }
    std::vector<LabelRequest> labels;
    for (const ImageMark& mark : marks) {
        labels.push_back({labelAnchor(mark, positionOf), burnedSize(mark.label, sizes), 0.7 * sizes.textPx});
    }
    const std::vector<Eigen::Vector2d> corners = placeLabels(labels, obstacles);
    for (std::size_t i = 0; i < marks.size(); ++i) {
        if (!marks[i].label.empty()) {
            burnLabel(image, marks[i].label, corners[i], sizes);
        }
    }
}

/// Draws the mesh onto a band of rows that starts at `top`; `band` is the temporary canvas.
void fillBand(core::ColorImage& image, const StrokeMesh& mesh, int top, std::vector<std::uint32_t>& band)
{
    const Canvas canvas{band.data(), image.width, std::min(markBandHeight, image.height - top)};
    std::uint8_t* rgb = image.rgb.data() + 3 * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(top);
    for (std::size_t i = 0; i < canvas.pixelCount(); ++i) {
        band[i] = packColor(rgb[3 * i], rgb[3 * i + 1], rgb[3 * i + 2]);
    }
    fillStrokes(mesh, image.height - top, canvas);
    for (std::size_t i = 0; i < canvas.pixelCount(); ++i) {
        rgb[3 * i] = static_cast<std::uint8_t>(band[i] >> 16U);
        rgb[3 * i + 1] = static_cast<std::uint8_t>(band[i] >> 8U);
        rgb[3 * i + 2] = static_cast<std::uint8_t>(band[i]);
    }
}

}   // namespace

void burnMarks(core::ColorImage& image, const std::vector<ImageMark>& marks, const ViewRect& part,
               const BurnSizes& sizes, const std::vector<Eigen::Vector2d>& avoided)
{
    if (marks.empty()) {
        return;
    }
    const PixelMapping positionOf = placeIn(image, part);
    StrokeMesh mesh;
    addMarks(mesh, marks, positionOf, image.height, sizes);
    std::vector<std::uint32_t> band(static_cast<std::size_t>(image.width) *
                                    static_cast<std::size_t>(std::min(image.height, markBandHeight)));
    for (int top = 0; top < image.height; top += markBandHeight) {
        fillBand(image, mesh, top, band);
    }
    addLabels(image, marks, positionOf, sizes, avoided);
}

void burnMarks(VectorImage& image, const std::vector<ImageMark>& marks, const ViewRect& part, const BurnSizes& sizes,
               const std::vector<Eigen::Vector2d>& avoided)
{
    const PixelMapping positionOf = placeIn(image, part);
    StrokeMesh mesh;
    mesh.shapes = &image.shapes;
    addMarks(mesh, marks, positionOf, image.height, sizes);
    addLabels(image, marks, positionOf, sizes, avoided);
}

}   // namespace angiopose::ui
