#include "ui/slices/slice_image.h"

#include "core/support/parallel_for.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace angiopose::ui {
namespace {

constexpr int bandRows = 64;   // rows per band; bands are rendered in parallel
constexpr int maxThreads = 4;

/// Two slice pixels between which a screen pixel is interpolated along one axis.
struct Station {
    int low = -1;   ///< −1 if outside the slice
    int high = -1;
    int nearest = -1;
    float fraction = 0.0F;   ///< weight of the higher pixel
};

std::vector<Station> stationsAlong(int screenPx, int slicePx, double first, double step)
{
    std::vector<Station> stations(static_cast<std::size_t>(screenPx));
    for (int i = 0; i < screenPx; ++i) {
        const double at = first + i * step;
        if (at < -0.5 || at >= slicePx - 0.5) {
            continue;
        }
        Station& station = stations[static_cast<std::size_t>(i)];
        const double inside = std::clamp(at, 0.0, slicePx - 1.0);
        station.low = static_cast<int>(inside);
        station.high = std::min(station.low + 1, slicePx - 1);
        station.fraction = static_cast<float>(inside - station.low);
        station.nearest = static_cast<int>(std::lround(inside));
    }
    return stations;
}

/// Lookup tables from gray level to color, two per mask tint.
class ColorTable {
public:
    ColorTable(const SliceTints& tints) : lastTint_(tints.mask.size())
    {
        for (std::size_t value = 0; value <= lastTint_; ++value) {
            const MaskTint tint = value == 0 ? MaskTint{{}, 0.0} : tints.mask[value - 1];
            for (const MaskTint& above : {MaskTint{{}, 0.0}, tints.preview}) {
                auto& colors = transferFunction_.emplace_back();
                for (std::size_t gray = 0; gray < colors.size(); ++gray) {
                    const auto level = static_cast<std::uint8_t>(gray);
                    const Color below = mixed({level, level, level}, tint.color, tint.opacity);
                    colors[gray] = rgb(mixed(below, above.color, above.opacity));
                }
            }
        }
    }
    QRgb operator()(int gray, std::uint8_t mask, bool isPreview) const
    {
        const std::size_t tint = std::min<std::size_t>(mask, lastTint_);
        return transferFunction_[2 * tint + (isPreview ? 1U : 0U)][static_cast<std::size_t>(gray)];
    }

private:
    static QRgb rgb(const Color& color) { return qRgb(color.red, color.green, color.blue); }
    std::size_t lastTint_;
    std::vector<std::array<QRgb, 256>> transferFunction_;   ///< two per mask value: without and with preview
};

/// Interpolates a row between two adjacent rows of the slice.
void mixRows(const SliceContent& content, const Station& row, std::vector<float>& mixed)
{
    const auto width = static_cast<std::size_t>(content.grid.width);
    const float* above = content.values.data() + static_cast<std::size_t>(row.low) * width;
    const float* below = content.values.data() + static_cast<std::size_t>(row.high) * width;
    for (std::size_t i = 0; i < width; ++i) {
        mixed[i] = above[i] + row.fraction * (below[i] - above[i]);
    }
}

/// Returns the stations for the columns and rows of the screen image.
std::pair<std::vector<Station>, std::vector<Station>> screenStations(const core::SliceGrid& grid,
                                                                     const ImageViewport& viewport,
                                                                     const QSize& deviceSize, double devicePxPerPx)
{
    const double unitMm = pixelSizeMm(grid);
    const double perColumn = unitMm / grid.columnStep.norm();
    const double perRow = unitMm / grid.rowStep.norm();
    const double half = 0.5 / devicePxPerPx;
    const Eigen::Vector2d first = viewport.imageFromWidget({half, half});
    const double step = 1.0 / (viewport.zoom() * devicePxPerPx);
    return {stationsAlong(deviceSize.width(), grid.width, first.x() * perColumn, step * perColumn),
            stationsAlong(deviceSize.height(), grid.height, first.y() * perRow, step * perRow)};
}

struct RowPainter {
    const std::vector<Station>& columns;
    const ColorTable& colors;
    float scale;
    float offset;
    float previewFrom;

    void paint(const float* values, const std::uint8_t* mask, QRgb* pixels) const
    {
        for (std::size_t x = 0; x < columns.size(); ++x) {
            const Station& at = columns[x];
            if (at.low < 0) {
                continue;
            }
            float value = std::numeric_limits<float>::quiet_NaN();
            int gray = 0;
            if (values != nullptr) {
                value = values[at.low] + at.fraction * (values[at.high] - values[at.low]);
                const float scaled = value * scale + offset;
                gray = scaled > 255.0F ? 255 : scaled > 0.0F ? static_cast<int>(scaled) : 0;   // maps NaN to 0
            }
            pixels[x] = colors(gray, mask != nullptr ? mask[at.nearest] : std::uint8_t{0}, value >= previewFrom);
        }
    }
};

void paintRow(const SliceContent& content, const Station& row, const RowPainter& painter, std::vector<float>& mixed,
              QRgb* pixels)
{
    const bool hasValues = !content.values.empty();
    if (hasValues) {
        mixRows(content, row, mixed);
    }
    const std::size_t nearest = static_cast<std::size_t>(row.nearest) * static_cast<std::size_t>(content.grid.width);
    painter.paint(hasValues ? mixed.data() : nullptr, content.mask.empty() ? nullptr : content.mask.data() + nearest,
                  pixels);
}

}   // namespace

double pixelSizeMm(const core::SliceGrid& grid)
{
    return std::min(grid.columnStep.norm(), grid.rowStep.norm());
}

QImage sliceImage(const SliceContent& content, const GrayWindow& window, const SliceTints& tints,
                  const ImageViewport& viewport, const QSize& deviceSize, double devicePxPerPx)
{
    QImage image(deviceSize, QImage::Format_RGB32);
    image.fill(Qt::black);
    repaintSliceRows(image, {0, deviceSize.height()}, content, window, tints, viewport, devicePxPerPx);
    return image;
}

void repaintSliceRows(QImage& image, std::pair<int, int> deviceRows, const SliceContent& content,
                      const GrayWindow& window, const SliceTints& tints, const ImageViewport& viewport,
                      double devicePxPerPx)
{
    const core::SliceGrid& grid = content.grid;
    const auto [first, end] = deviceRows;
    if (grid.width == 0 || image.isNull() || first >= end) {
        return;
    }
    const auto stations = screenStations(grid, viewport, image.size(), devicePxPerPx);
    const std::vector<Station>& rows = stations.second;
    auto* pixels = reinterpret_cast<QRgb*>(image.bits());
    const std::ptrdiff_t pixelsPerLine = image.bytesPerLine() / static_cast<qsizetype>(sizeof(QRgb));
    const auto bands = static_cast<std::size_t>((end - first + bandRows - 1) / bandRows);
    const ColorTable colors(tints);
    const double width = std::max(window.width, 1e-3);
    const RowPainter painter{stations.first, colors, static_cast<float>(255.0 / width),
                             static_cast<float>(127.5 - 255.0 * window.level / width),
                             static_cast<float>(tints.previewFrom.value_or(std::numeric_limits<double>::infinity()))};
    const auto paintRows = [&](int from, int to) {
        std::vector<float> mixed(static_cast<std::size_t>(grid.width));
        for (int y = from; y < to; ++y) {
            if (rows[static_cast<std::size_t>(y)].low >= 0) {
                paintRow(content, rows[static_cast<std::size_t>(y)], painter, mixed, pixels + y * pixelsPerLine);
            }
        }
    };
    core::parallelFor(
        bands, std::min(maxThreads, core::threadCount(0)),
        [&](std::size_t band) {
            const int from = first + static_cast<int>(band) * bandRows;
            paintRows(from, std::min(from + bandRows, end));
        },
        [](double) { return true; });
}

}   // namespace angiopose::ui
