#include "core/tracing/vesselness.h"

#include "core/imaging/image_filters.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace core {
namespace {

constexpr int directionCount = 12;
constexpr double scaleRatio = 1.5;
// A tube seen through its chord answers most strongly at about this share of its radius.
constexpr double sigmaPerRadius = 0.7;
constexpr double finestSigmaPx = 0.8;
// Scales above this are filtered on a halved image, where they cost a quarter.
constexpr double coarsestSigmaOnGrid = 1.7;
constexpr double lineReachInSigmas = 2.5;
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

/// Whole-pixel steps along one direction with Gaussian weights that sum to one.
struct LineTap {
    int dx;
    int dy;
    float weight;
};

std::vector<LineTap> lineTaps(double angle, double sigmaPx)
{
    const double reach = lineReachInSigmas * sigmaPx;
    const int taps = std::max(1, static_cast<int>(std::lround(reach)));
    std::vector<LineTap> line;
    float sum = 0.0F;
    for (int k = -taps; k <= taps; ++k) {
        const double along = reach * k / taps;
        const auto weight = static_cast<float>(std::exp(-0.5 * std::pow(1.5 * k / taps, 2)));
        line.push_back({static_cast<int>(std::lround(along * std::cos(angle))),
                        static_cast<int>(std::lround(along * std::sin(angle))), weight});
        sum += weight;
    }
    for (LineTap& tap : line) {
        tap.weight /= sum;
    }
    return line;
}

/// Ridge across direction `angle` in rows [firstRow, lastRow), padded left and right by `margin` edge values.
struct RidgeTile {
    int margin = 0;
    int stride = 0;
    int firstRow = 0;
    std::vector<float> values;

    float* row(int y) { return values.data() + static_cast<std::size_t>((y - firstRow) * stride + margin); }
};

void fillTile(RidgeTile& tile, const Derivatives& d, double angle, int lastRow)
{
    const int width = d.x.width;
    const auto nx = static_cast<float>(-std::sin(angle));
    const auto ny = static_cast<float>(std::cos(angle));
    for (int y = tile.firstRow; y < lastRow; ++y) {
        const std::size_t start = d.x.index(0, std::clamp(y, 0, d.x.height - 1));
        const float* dx = &d.x.pixels[start];
        const float* dy = &d.y.pixels[start];
        const float* dxx = &d.xx.pixels[start];
        const float* dxy = &d.xy.pixels[start];
        const float* dyy = &d.yy.pixels[start];
        float* ridge = tile.row(y);
        for (int x = 0; x < width; ++x) {
            const float curvature = nx * nx * dxx[x] + 2.0F * nx * ny * dxy[x] + ny * ny * dyy[x];
            ridge[x] = -curvature - std::fabs(nx * dx[x] + ny * dy[x]);
        }
        std::fill(ridge - tile.margin, ridge, ridge[0]);
        std::fill(ridge + width, ridge + width + tile.margin, ridge[width - 1]);
    }
}

/// Largest line average over all directions, at least 0.
ImageF orientedRidges(const Derivatives& d, double sigmaPx)
{
    const int width = d.x.width;
    const int height = d.x.height;
    ImageF best(width, height);
    const int margin = static_cast<int>(std::ceil(lineReachInSigmas * sigmaPx)) + 1;
    RidgeTile tile{margin, width + 2 * margin, 0, {}};
    tile.values.resize(static_cast<std::size_t>(tile.stride) * static_cast<std::size_t>(rowsPerTile + 2 * margin));
    std::vector<float> sum(static_cast<std::size_t>(width));
    for (int top = 0; top < height; top += rowsPerTile) {
        const int bottom = std::min(height, top + rowsPerTile);
        tile.firstRow = top - margin;
        for (int k = 0; k < directionCount; ++k) {
            const double angle = std::numbers::pi * k / directionCount;
            fillTile(tile, d, angle, bottom + margin);
            const std::vector<LineTap> taps = lineTaps(angle, sigmaPx);
            for (int y = top; y < bottom; ++y) {
                std::fill(sum.begin(), sum.end(), 0.0F);
                for (const LineTap& tap : taps) {
                    const float* ridge = tile.row(y + tap.dy) + tap.dx;
                    for (int x = 0; x < width; ++x) {
                        sum[static_cast<std::size_t>(x)] += tap.weight * ridge[x];
                    }
                }
                float* strongest = &best.at(0, y);
                for (int x = 0; x < width; ++x) {
                    strongest[x] = std::max(strongest[x], sum[static_cast<std::size_t>(x)]);
                }
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
