#include "ui/scenes/resample_frame.h"

#include "ui/scenes/row_bands.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace angiopose::ui {
namespace {

/// Source pixels that contribute to each target pixel, with their weights, along one axis.
struct Taps {
    struct Target {
        int first = 0;   ///< first source pixel
        int count = 0;   ///< number of source pixels; 0 if outside the image
        std::size_t weights = 0;   ///< index of the first weight
    };
    std::vector<Target> targets;
    std::vector<float> weights;   ///< normalized to a sum of 1 for each target pixel
};

void addTarget(Taps& taps, double center, double halfWidth, int sourceSize)
{
    Taps::Target target{0, 0, taps.weights.size()};
    if (center >= -0.5 && center <= sourceSize - 0.5) {
        const double inside = std::clamp(center, 0.0, sourceSize - 1.0);
        target.first = std::max(0, static_cast<int>(std::floor(inside - halfWidth)) + 1);
        const int last = std::min(sourceSize - 1, static_cast<int>(std::ceil(inside + halfWidth)) - 1);
        double sum = 0.0;
        for (int i = target.first; i <= last; ++i) {
            sum += 1.0 - std::abs(i - inside) / halfWidth;
        }
        for (int i = target.first; i <= last; ++i) {
            taps.weights.push_back(static_cast<float>((1.0 - std::abs(i - inside) / halfWidth) / sum));
        }
        target.count = last - target.first + 1;
    }
    taps.targets.push_back(target);
}

Taps tapsOf(double from, double to, int targetSize, int sourceSize, Interpolation interpolation)
{
    Taps taps;
    const double step = (to - from) / targetSize;
    for (int k = 0; k < targetSize; ++k) {
        const double center = from + (k + 0.5) * step;
        if (interpolation == Interpolation::Nearest) {
            addTarget(taps, center >= -0.5 && center <= sourceSize - 0.5 ? std::round(center) : center, 1e-3,
                      sourceSize);
        } else {
            addTarget(taps, center, std::max(1.0, step), sourceSize);
        }
    }
    return taps;
}

/// Computes the weighted sum of the source rows of a target row, at source width.
void blendRows(const core::Image2d<std::uint8_t>& gray, const Taps& down, const Taps::Target& target,
               std::vector<float>& line)
{
    std::fill(line.begin(), line.end(), 0.5F);   // 0.5 rounds the later conversion to integers
    for (int k = 0; k < target.count; ++k) {
        const float fraction = down.weights[target.weights + static_cast<std::size_t>(k)];
        const std::uint8_t* source = gray.pixels.data() + gray.index(0, target.first + k);
        for (std::size_t x = 0; x < line.size(); ++x) {
            line[x] += fraction * static_cast<float>(source[x]);
        }
    }
}

void blendColumns(const std::vector<float>& line, const Taps& across, std::uint32_t background, std::uint32_t* row)
{
    for (const Taps::Target& target : across.targets) {
        if (target.count == 0) {
            *row++ = background;
            continue;
        }
        const float* shares = across.weights.data() + target.weights;
        const float* source = line.data() + target.first;
        float value = 0.0F;
        for (int k = 0; k < target.count; ++k) {
            value += shares[k] * source[k];
        }
        *row++ = 0xFF000000U | 0x010101U * static_cast<std::uint32_t>(value);
    }
}

}   // namespace

void resampleFrame(const core::Image2d<std::uint8_t>& gray, const ViewRect& rect, Interpolation interpolation,
                   const Color& background, Canvas canvas)
{
    const std::uint32_t outside = packColor(background);
    const Taps across = tapsOf(rect.left, rect.right, canvas.width, gray.width, interpolation);
    const Taps down = tapsOf(rect.top, rect.bottom, canvas.height, gray.height, interpolation);
    forEachBand(canvas.height, [&](const Rows& rows) {
        std::vector<float> line(static_cast<std::size_t>(gray.width));
        for (int y = rows.from; y < rows.to; ++y) {
            const Taps::Target& target = down.targets[static_cast<std::size_t>(y)];
            if (target.count == 0) {
                std::fill_n(canvas.row(y), canvas.width, outside);
                continue;
            }
            blendRows(gray, down, target, line);
            blendColumns(line, across, outside, canvas.row(y));
        }
    });
}

}   // namespace angiopose::ui
