#include "core/tracing/clutter_level.h"

#include "core/imaging/grey_statistics.h"
#include "core/imaging/mask_morphology.h"
#include "core/support/at_once.h"
#include "core/tracing/vesselness.h"

#include <algorithm>

namespace core {
namespace {

constexpr double rank = 0.9;   // above most noise, below what the flanks of vessels add to the far tail
constexpr int rimPx = 6;   // where filters see the edge of the field
constexpr double clearMultiple = 4.0;
constexpr int flankPx = 10;
constexpr std::size_t leastShareLeft = 10;   // one part in so many, else all of the field counts
constexpr int mostBands = 4;
constexpr int leastBands = 2;
constexpr int bandRows = 40;
constexpr int enoughPixels = 82000;   // for the statistics
constexpr int marginRows = 12;   // on either side, as filters reach

struct Band {
    int firstRow = 0;
    int rowCount = 0;
};

/// The whole image, or in larger ones some evenly spread bands.
std::vector<Band> bandsOf(int width, int height)
{
    const int bandCount = std::clamp(enoughPixels / (bandRows * std::max(1, width)), leastBands, mostBands);
    if (height < 2 * mostBands * (bandRows + 2 * marginRows)) {
        return {{0, height}};
    }
    std::vector<Band> bands;
    bands.reserve(static_cast<std::size_t>(bandCount));
    for (int k = 0; k < bandCount; ++k) {
        bands.push_back({(2 * k + 1) * height / (2 * bandCount) - bandRows / 2, bandRows});
    }
    return bands;
}

/// The band with its margins as an image of its own, bright for dark.
ImageF invertedBand(const ImageF& opacity, const Band& band, int firstRow)
{
    const int endRow = std::min(opacity.height, band.firstRow + band.rowCount + marginRows);
    ImageF inverted(opacity.width, endRow - firstRow);
    const auto begin = opacity.pixels.begin() + static_cast<std::ptrdiff_t>(opacity.index(0, firstRow));
    std::transform(begin, begin + static_cast<std::ptrdiff_t>(inverted.pixels.size()), inverted.pixels.begin(),
                   [](float value) { return -value; });
    return inverted;
}

/// Ridges of the other sign in all bands; -1 elsewhere.
ImageF invertedRidges(const ImageF& opacity, double minRadiusPx, double maxRadiusPx)
{
    ImageF inverted(opacity.width, opacity.height, -1.0F);
    for (const Band& band : bandsOf(opacity.width, opacity.height)) {
        const int firstRow = std::max(0, band.firstRow - marginRows);
        const ImageF ridges = ridgeStrength(invertedBand(opacity, band, firstRow), minRadiusPx, maxRadiusPx);
        const auto begin =
            ridges.pixels.begin() + static_cast<std::ptrdiff_t>(ridges.index(0, band.firstRow - firstRow));
        std::copy_n(begin, ridges.index(0, band.rowCount),
                    inverted.pixels.begin() + static_cast<std::ptrdiff_t>(inverted.index(0, band.firstRow)));
    }
    return inverted;
}

std::vector<float> measuredWhere(const Mask2d& inside, const ImageF& inverted)
{
    std::vector<float> values;
    for (std::size_t i = 0; i < inverted.pixels.size(); ++i) {
        if (inside.pixels[i] != 0 && inverted.pixels[i] >= 0.0F) {
            values.push_back(inverted.pixels[i]);
        }
    }
    return values;
}

Mask2d awayFromVessels(Mask2d inside, const ImageF& ridges, double clearRidge)
{
    Mask2d vessels(ridges.width, ridges.height);
    for (std::size_t i = 0; i < vessels.pixels.size(); ++i) {
        vessels.pixels[i] = ridges.pixels[i] > clearRidge ? 255 : 0;
    }
    vessels = dilated(vessels, flankPx);
    for (std::size_t i = 0; i < inside.pixels.size(); ++i) {
        inside.pixels[i] = vessels.pixels[i] != 0 ? 0 : inside.pixels[i];
    }
    return inside;
}

}   // namespace

double clutterLevel(const ImageF& opacity, const ImageF& ridges, const Mask2d& field, double minRadiusPx,
                    double maxRadiusPx)
{
    ImageF inverted;
    Mask2d inside;
    atOnce([&] { inverted = invertedRidges(opacity, minRadiusPx, maxRadiusPx); },
           [&] { inside = eroded(field, rimPx); });
    std::vector<float> everywhere = measuredWhere(inside, inverted);
    if (everywhere.empty()) {
        return 0.0;
    }
    const std::size_t enough = everywhere.size() / leastShareLeft;
    const double first = ranked(std::move(everywhere), rank);
    std::vector<float> away = measuredWhere(awayFromVessels(inside, ridges, clearMultiple * first), inverted);
    return away.size() > enough ? ranked(std::move(away), rank) : first;
}

}   // namespace core
