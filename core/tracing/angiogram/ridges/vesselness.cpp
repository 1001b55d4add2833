#include "core/tracing/angiogram/ridges/vesselness.h"

#include "core/imaging/image_filters.h"
#include "core/support/parallel_for.h"
#include "core/support/wide_vectors.h"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace angiopose::core {
namespace {

constexpr int directionCount = 12;
constexpr double scaleRatio = 1.5;
// Slightly finer than the scale of the strongest response to a round tube (0.7 r), to keep adjacent vessels apart.
constexpr double sigmaPerRadius = 0.52;
constexpr double minSigmaPx = 0.8;
// Coarser scales are filtered on a half-size image at a quarter of the cost.
constexpr double maxSigmaOnGrid = 1.7;
constexpr double lineReachInSigmas = 2.5;
constexpr double minLineReachPx = 4.0;   // lower limit, because shorter lines would not average out enough noise
constexpr std::size_t tapCount = 5;   // samples along the line, mostly 1.25 σ apart: fine enough at scale σ
constexpr float slopeWeight = 0.85F;
// Fraction of the difference between the two sides by which a one-sided ridge, as at a blob, is reduced.
constexpr float oneSidedPenalty = 0.5F;
constexpr int rowsPerStrip = 32;
constexpr int maxFilterThreads = 2;   // memory bandwidth limits the gain from more threads

/// Scale-normalized first and second Gaussian derivatives of some rows of an image.
struct Derivatives {
    ImageF x, y, xx, xy, yy;
};

/// Row to differentiate, with the rows above and below; the pointers start at the second pixel.
struct ThreeRows {
    const float* above;
    const float* here;
    const float* below;
};

/// Computes central differences of a row except its first and last pixel. The `__restrict` pointers promise the
/// compiler that the targets do not overlap.
ANGIOPOSE_WIDE_VECTORS
void differentiateRow(const ThreeRows& rows, Derivatives& d, std::size_t start, float sigma)
{
    const float* __restrict above = rows.above;
    const float* __restrict here = rows.here;
    const float* __restrict below = rows.below;
    float* __restrict dx = &d.x.pixels[start];
    float* __restrict dy = &d.y.pixels[start];
    float* __restrict dxx = &d.xx.pixels[start];
    float* __restrict dxy = &d.xy.pixels[start];
    float* __restrict dyy = &d.yy.pixels[start];
    const float first = 0.5F * sigma;
    const float second = sigma * sigma;
    for (int x = 0; x < d.x.width - 2; ++x) {
        dx[x] = first * (here[x + 1] - here[x - 1]);
        dy[x] = first * (below[x] - above[x]);
        dxx[x] = second * (here[x + 1] - 2.0F * here[x] + here[x - 1]);
        dyy[x] = second * (below[x] - 2.0F * here[x] + above[x]);
        dxy[x] = 0.25F * second * (below[x + 1] - below[x - 1] - above[x + 1] + above[x - 1]);
    }
}

/// Computes the derivatives of as many rows as `d` has, from `firstRow` on; edge rows repeat beyond the image.
void differentiate(const ImageF& smooth, int firstRow, double sigmaPx, Derivatives& d)
{
    for (int row = 0; row < d.x.height; ++row) {
        const int y = std::clamp(firstRow + row, 0, smooth.height - 1);
        const ThreeRows rows{&smooth.at(1, std::max(0, y - 1)), &smooth.at(1, y),
                             &smooth.at(1, std::min(smooth.height - 1, y + 1))};
        differentiateRow(rows, d, d.x.index(1, row), static_cast<float>(sigmaPx));
        for (ImageF* derivative : {&d.x, &d.y, &d.xx, &d.xy, &d.yy}) {
            derivative->at(0, row) = derivative->at(1, row);
            derivative->at(d.x.width - 1, row) = derivative->at(d.x.width - 2, row);
        }
    }
}

/// Whole-pixel steps along one direction, from back to front, with Gaussian weights whose sum is the scale's weight.
struct LineTaps {
    std::array<int, tapCount> dx{};
    std::array<int, tapCount> dy{};
    std::array<float, tapCount> weights{};
};

double lineReachPx(double sigmaPx)
{
    return std::max(minLineReachPx, lineReachInSigmas * sigmaPx);
}

LineTaps lineTaps(double angle, const RidgeScale& scale)
{
    const double reachPx = lineReachPx(scale.sigmaPx);
    LineTaps taps;
    float sum = 0.0F;
    for (std::size_t i = 0; i < tapCount; ++i) {
        const double position = 2.0 * static_cast<double>(i) / (tapCount - 1) - 1.0;   // -1 … 1
        const double along = position * reachPx;
        taps.dx[i] = static_cast<int>(std::lround(along * std::cos(angle)));
        taps.dy[i] = static_cast<int>(std::lround(along * std::sin(angle)));
        taps.weights[i] = static_cast<float>(std::exp(-0.5 * std::pow(1.5 * position, 2)));
        sum += taps.weights[i];
    }
    for (float& weight : taps.weights) {
        weight *= static_cast<float>(scale.weight) / sum;
    }
    return taps;
}

/// Computes curvature minus slope along the normal `n` of the direction, for the pixels of one row.
ANGIOPOSE_WIDE_VECTORS
void computeRidgeRow(const Derivatives& d, std::size_t start, const Eigen::Vector2f& n, float* ridge)
{
    const float* dx = &d.x.pixels[start];
    const float* dy = &d.y.pixels[start];
    const float* dxx = &d.xx.pixels[start];
    const float* dxy = &d.xy.pixels[start];
    const float* dyy = &d.yy.pixels[start];
    const float nx = n.x();
    const float ny = n.y();
    const float nxx = nx * nx;
    const float nxy = 2.0F * nx * ny;
    const float nyy = ny * ny;
    for (int x = 0; x < d.x.width; ++x) {
        const float curvature = nxx * dxx[x] + nxy * dxy[x] + nyy * dyy[x];
        ridge[x] = -curvature - slopeWeight * std::fabs(nx * dx[x] + ny * dy[x]);
    }
}

/// Computes the ridges across direction `angle`, padded left and right with `margin` edge values.
void computeRidges(const Derivatives& d, double angle, int margin, ImageF& ridges)
{
    const Eigen::Vector2f normal(static_cast<float>(-std::sin(angle)), static_cast<float>(std::cos(angle)));
    for (int row = 0; row < ridges.height; ++row) {
        float* ridge = &ridges.at(margin, row);
        computeRidgeRow(d, d.x.index(0, row), normal, ridge);
        std::fill(ridge - margin, ridge, ridge[0]);
        std::fill(ridge + d.x.width, ridge + d.x.width + margin, ridge[d.x.width - 1]);
    }
}

/// Raises `strongest` at each pixel to the mean ridge strength along the line through that pixel, minus the one-sided
/// penalty. `rows` are the ridge rows already shifted by the taps, from back to front.
ANGIOPOSE_WIDE_VECTORS
void updateWithLineMean(float* strongest, int width, const std::array<const float*, tapCount>& rows,
                        const std::array<float, tapCount>& weights)
{
    for (int x = 0; x < width; ++x) {
        const float half = 0.5F * weights[2] * rows[2][x];
        const float back = weights[0] * rows[0][x] + weights[1] * rows[1][x] + half;
        const float front = weights[3] * rows[3][x] + weights[4] * rows[4][x] + half;
        const float mean = back + front - oneSidedPenalty * std::fabs(back - front);
        strongest[x] = strongest[x] > mean ? strongest[x] : mean;
    }
}

/// Working memory of one thread for strips of rows; a strip fits into the cache.
class StripWorker {
public:
    StripWorker(const ImageF& smooth, const RidgeScale& scale)
        : smooth_(smooth),
          scale_(scale),
          margin_(static_cast<int>(std::ceil(lineReachPx(scale.sigmaPx))) + 1),
          ridges_(smooth.width + 2 * margin_, rowsPerStrip + 2 * margin_)
    {
        const ImageF strip(smooth.width, ridges_.height);
        d_ = {strip, strip, strip, strip, strip};
    }

    /// Updates the rows of `best` in the strip that starts at row `top`.
    void processStrip(int top, ImageF& best)
    {
        const int rowCount = std::min(rowsPerStrip, smooth_.height - top);
        differentiate(smooth_, top - margin_, scale_.sigmaPx, d_);
        for (int k = 0; k < directionCount; ++k) {
            const double angle = std::numbers::pi * k / directionCount;
            computeRidges(d_, angle, margin_, ridges_);
            const LineTaps taps = lineTaps(angle, scale_);
            for (int row = 0; row < rowCount; ++row) {
                std::array<const float*, tapCount> rows{};
                for (std::size_t i = 0; i < tapCount; ++i) {
                    rows[i] = &ridges_.at(margin_ + taps.dx[i], margin_ + row + taps.dy[i]);
                }
                updateWithLineMean(&best.at(0, top + row), smooth_.width, rows, taps.weights);
            }
        }
    }

private:
    const ImageF& smooth_;
    RidgeScale scale_;
    int margin_;
    ImageF ridges_;
    Derivatives d_;
};

/// Raises `best` to the largest line mean over all directions at one scale; the number of threads has no influence.
void updateWithScale(const ImageF& image, const RidgeScale& scale, ImageF& best)
{
    const int workers = std::min(maxFilterThreads, threadCount(0));
    const ImageF smooth = gaussianBlur(image, scale.sigmaPx, workers);
    parallelFor(
        static_cast<std::size_t>(workers), workers,
        [&](std::size_t number) {
            StripWorker worker(smooth, scale);
            for (int top = static_cast<int>(number) * rowsPerStrip; top < image.height; top += workers * rowsPerStrip) {
                worker.processStrip(top, best);
            }
        },
        [](double) { return true; });
}

}   // namespace

std::vector<RidgeScale> ridgeScales(double minRadiusPx, double maxRadiusPx)
{
    const double finest = std::max(minSigmaPx, sigmaPerRadius * minRadiusPx);
    const double coarsest = std::max(finest, sigmaPerRadius * maxRadiusPx);
    const int steps = static_cast<int>(std::ceil(std::log(coarsest / finest) / std::log(scaleRatio) - 1e-9));
    std::vector<RidgeScale> scales;
    for (int k = 0; k <= steps; ++k) {
        scales.push_back({finest * std::pow(coarsest / finest, steps > 0 ? static_cast<double>(k) / steps : 0.0), 1.0});
    }
    return scales;
}

ImageF ridgeStrength(const ImageF& opacity, double minRadiusPx, double maxRadiusPx)
{
    return ridgeStrength(opacity, ridgeScales(minRadiusPx, maxRadiusPx));
}

ImageF ridgeStrength(const ImageF& opacity, const std::vector<RidgeScale>& scales)
{
    constexpr int smallestSide = 8;
    if (std::min(opacity.width, opacity.height) < smallestSide) {
        return ImageF(opacity.width, opacity.height);
    }
    ImageF grid = opacity;
    double gridSpacingPx = 1.0;
    std::vector<ImageF> levels{ImageF(grid.width, grid.height)};   // strongest ridges per level of halved size
    for (const RidgeScale& scale : scales) {
        while (scale.sigmaPx / gridSpacingPx > maxSigmaOnGrid &&
               std::min(grid.width, grid.height) >= 2 * smallestSide) {
            grid = halveSize(grid);
            gridSpacingPx *= 2.0;
            levels.emplace_back(grid.width, grid.height);
        }
        updateWithScale(grid, {scale.sigmaPx / gridSpacingPx, scale.weight}, levels.back());
    }
    while (levels.size() > 1) {
        ImageF& finer = levels[levels.size() - 2];
        const ImageF coarser = upsample(levels.back(), 2, finer.width, finer.height);
        std::transform(finer.pixels.begin(), finer.pixels.end(), coarser.pixels.begin(), finer.pixels.begin(),
                       [](float a, float b) { return std::max(a, b); });
        levels.pop_back();
    }
    return std::move(levels.front());
}

}   // namespace angiopose::core
