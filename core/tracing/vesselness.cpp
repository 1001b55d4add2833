#include "core/tracing/vesselness.h"

#include "core/imaging/image_filters.h"
#include "core/support/wide_vectors.h"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace core {
namespace {

constexpr int directionCount = 12;
constexpr double scaleRatio = 1.5;
// Somewhat finer than where a round tube answers most strongly (0.7 r), which keeps neighbours apart.
constexpr double sigmaPerRadius = 0.52;
constexpr double finestSigmaPx = 0.8;
// Scales above this are filtered on a halved image, where they cost a quarter.
constexpr double coarsestSigmaOnGrid = 1.7;
constexpr double lineReachInSigmas = 2.5;
constexpr std::size_t tapCount = 5;   // 1.25 σ apart, which the smoothness at scale σ allows
constexpr float slopeWeight = 0.85F;
// Where the ridge goes on to one side only, as at blobs, it counts less by this share of the difference.
constexpr float oneSidedPenalty = 0.5F;
constexpr int rowsPerTile = 48;

/// Scale-normalised first and second Gaussian derivatives of one image.
struct Derivatives {
    ImageF x, y, xx, xy, yy;
};

Derivatives derivativesOf(const ImageF& image, double sigmaPx)
{
    const ImageF smooth = blurred(image, sigmaPx);
    const int width = image.width;
    const int height = image.height;
    Derivatives d{ImageF(width, height), ImageF(width, height), ImageF(width, height), ImageF(width, height),
                  ImageF(width, height)};
    const auto first = static_cast<float>(0.5 * sigmaPx);
    const auto second = static_cast<float>(sigmaPx * sigmaPx);
    for (int y = 0; y < height; ++y) {
        const float* above = &smooth.at(0, std::max(0, y - 1));
        const float* here = &smooth.at(0, y);
        const float* below = &smooth.at(0, std::min(height - 1, y + 1));
        const std::size_t row = d.x.index(0, y);
        const auto difference = [&](int x, int left, int right) {
            const std::size_t i = row + static_cast<std::size_t>(x);
            d.x.pixels[i] = first * (here[right] - here[left]);
            d.y.pixels[i] = first * (below[x] - above[x]);
            d.xx.pixels[i] = second * (here[right] - 2.0F * here[x] + here[left]);
            d.yy.pixels[i] = second * (below[x] - 2.0F * here[x] + above[x]);
            d.xy.pixels[i] = 0.25F * second * (below[right] - below[left] - above[right] + above[left]);
        };
        difference(0, 0, std::min(1, width - 1));
        for (int x = 1; x + 1 < width; ++x) {
            difference(x, x - 1, x + 1);
        }
        difference(width - 1, std::max(0, width - 2), width - 1);
    }
    return d;
}

/// Whole-pixel steps along one direction, from back to front, with Gaussian weights that sum to one.
struct LineTaps {
    std::array<int, tapCount> dx{};
    std::array<int, tapCount> dy{};
    std::array<float, tapCount> weights{};
};

LineTaps lineTaps(double angle, double sigmaPx)
{
    LineTaps taps;
    float sum = 0.0F;
    for (std::size_t i = 0; i < tapCount; ++i) {
        const double place = static_cast<double>(i) / (tapCount / 2) - 1.0;   // -1 … 1
        const double along = place * lineReachInSigmas * sigmaPx;
        taps.dx[i] = static_cast<int>(std::lround(along * std::cos(angle)));
        taps.dy[i] = static_cast<int>(std::lround(along * std::sin(angle)));
        taps.weights[i] = static_cast<float>(std::exp(-0.5 * std::pow(1.5 * place, 2)));
        sum += taps.weights[i];
    }
    for (float& weight : taps.weights) {
        weight /= sum;
    }
    return taps;
}

/// Ridge across direction `angle` in rows [firstRow, lastRow), padded left and right by `margin` edge values.
struct RidgeTile {
    int margin = 0;
    int stride = 0;
    int firstRow = 0;
    std::vector<float> values;
    float* row(int y) { return values.data() + static_cast<std::size_t>((y - firstRow) * stride + margin); }
};

/// Curvature minus slope across direction `n`, for the pixels of one row.
ANGIOPOSE_WIDE_VECTORS
void ridgeRow(const Derivatives& d, std::size_t start, const Eigen::Vector2f& n, float* ridge)
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

void fillTile(RidgeTile& tile, const Derivatives& d, double angle, int lastRow)
{
    const int width = d.x.width;
    const Eigen::Vector2f normal(static_cast<float>(-std::sin(angle)), static_cast<float>(std::cos(angle)));
    for (int y = tile.firstRow; y < lastRow; ++y) {
        float* ridge = tile.row(y);
        ridgeRow(d, d.x.index(0, std::clamp(y, 0, d.x.height - 1)), normal, ridge);
        std::fill(ridge - tile.margin, ridge, ridge[0]);
        std::fill(ridge + width, ridge + width + tile.margin, ridge[width - 1]);
    }
}

/// Raises `strongest` to the mean ridge along the line through each pixel, less the one-sided penalty. `rows` are the
/// ridge rows already shifted by the taps, from back to front.
ANGIOPOSE_WIDE_VECTORS
void raiseToLineMean(float* strongest, int width, const std::array<const float*, tapCount>& rows,
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

/// Largest line mean over all directions, at least 0.
ImageF orientedRidges(const Derivatives& d, double sigmaPx)
{
    const int width = d.x.width;
    const int height = d.x.height;
    ImageF best(width, height);
    const int margin = static_cast<int>(std::ceil(lineReachInSigmas * sigmaPx)) + 1;
    RidgeTile tile{margin, width + 2 * margin, 0, {}};
    tile.values.resize(static_cast<std::size_t>(tile.stride) * static_cast<std::size_t>(rowsPerTile + 2 * margin));
    for (int top = 0; top < height; top += rowsPerTile) {
        const int bottom = std::min(height, top + rowsPerTile);
        tile.firstRow = top - margin;
        for (int k = 0; k < directionCount; ++k) {
            const double angle = std::numbers::pi * k / directionCount;
            fillTile(tile, d, angle, bottom + margin);
            const LineTaps taps = lineTaps(angle, sigmaPx);
            for (int y = top; y < bottom; ++y) {
                std::array<const float*, tapCount> rows{};
                for (std::size_t i = 0; i < tapCount; ++i) {
                    rows[i] = tile.row(y + taps.dy[i]) + taps.dx[i];
                }
                raiseToLineMean(&best.at(0, y), width, rows, taps.weights);
            }
        }
    }
    return best;
}

std::vector<double> scalesFor(double minRadiusPx, double maxRadiusPx)
{
    const double finest = std::max(finestSigmaPx, sigmaPerRadius * minRadiusPx);
    const double coarsest = std::max(finest, sigmaPerRadius * maxRadiusPx);
    const int steps = static_cast<int>(std::ceil(std::log(coarsest / finest) / std::log(scaleRatio) - 1e-9));
    std::vector<double> sigmas;
    for (int k = 0; k <= steps; ++k) {
        sigmas.push_back(finest * std::pow(coarsest / finest, steps > 0 ? static_cast<double>(k) / steps : 0.0));
    }
    return sigmas;
}

}   // namespace

ImageF ridgeStrength(const ImageF& opacity, double minRadiusPx, double maxRadiusPx)
{
    ImageF strongest(opacity.width, opacity.height);
    ImageF grid = opacity;
    int factor = 1;
    for (const double sigma : scalesFor(minRadiusPx, maxRadiusPx)) {
        while (sigma / factor > coarsestSigmaOnGrid && std::min(grid.width, grid.height) > 8) {
            grid = halved(grid);
            factor *= 2;
        }
        const ImageF ridges = orientedRidges(derivativesOf(grid, sigma / factor), sigma / factor);
        const ImageF fine = factor > 1 ? enlarged(ridges, factor, opacity.width, opacity.height) : ridges;
        for (std::size_t i = 0; i < strongest.pixels.size(); ++i) {
            strongest.pixels[i] = std::max(strongest.pixels[i], fine.pixels[i]);
        }
    }
    return strongest;
}

}   // namespace core
