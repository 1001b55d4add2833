#include "core/tracing/angiogram/ridges/clutter_level.h"

#include "core/imaging/gray_statistics.h"
#include "core/imaging/mask_morphology.h"

#include <algorithm>
#include <utility>

namespace angiopose::core {
namespace {

constexpr double clutterQuantile = 0.9;   // quantile above most noise, but below the tail due to vessel flanks
constexpr double tailQuantile = 0.98;
// Ratio of these two quantiles if structures are present; lower for pure noise.
constexpr double tailRatio = 1.75;
constexpr double minWeight = 0.5;   // lower limit of scale weights; thin vessels must be found despite some noise
constexpr int clutterRimPx = 6;   // width of the border in which filters respond to the field edge
constexpr double clearMultiple = 4.0;
constexpr int flankPx = 10;
constexpr std::size_t minRemainderDivisor = 10;   // if less than 1/10 of the field has no vessels, all of it is used
constexpr int maxBands = 4;
constexpr int minBands = 2;
constexpr int bandRows = 40;
constexpr int sufficientPixels = 82000;   // pixels needed for stable statistics
constexpr int marginRows = 12;   // rows added on either side for the reach of the filters

struct Band {
    int firstRow = 0;
    int rowCount = 0;
};

/// Returns the whole image as one band, or several evenly spaced bands if the image is large.
std::vector<Band> bandsOf(int width, int height)
{
    const int bandCount = std::clamp(sufficientPixels / (bandRows * std::max(1, width)), minBands, maxBands);
    if (height < 2 * maxBands * (bandRows + 2 * marginRows)) {
        return {{0, height}};
    }
    std::vector<Band> bands;
    bands.reserve(static_cast<std::size_t>(bandCount));
    for (int k = 0; k < bandCount; ++k) {
        bands.push_back({(2 * k + 1) * height / (2 * bandCount) - bandRows / 2, bandRows});
    }
    return bands;
}

/// Returns the band with its margins as a separate, inverted image.
ImageF invertedBand(const ImageF& opacity, const Band& band, int firstRow)
{
    const int endRow = std::min(opacity.height, band.firstRow + band.rowCount + marginRows);
    ImageF inverted(opacity.width, endRow - firstRow);
    const auto begin = opacity.pixels.begin() + static_cast<std::ptrdiff_t>(opacity.index(0, firstRow));
    std::transform(begin, begin + static_cast<std::ptrdiff_t>(inverted.pixels.size()), inverted.pixels.begin(),
                   [](float value) { return -value; });
    return inverted;
}

/// Computes the ridges of the opposite sign in all bands; -1 elsewhere.
ImageF invertedRidges(const ImageF& opacity, const RidgeScale& scale)
{
    ImageF inverted(opacity.width, opacity.height, -1.0F);
    for (const Band& band : bandsOf(opacity.width, opacity.height)) {
        const int firstRow = std::max(0, band.firstRow - marginRows);
        const ImageF ridges = ridgeStrength(invertedBand(opacity, band, firstRow), {scale});
        const auto begin =
            ridges.pixels.begin() + static_cast<std::ptrdiff_t>(ridges.index(0, band.firstRow - firstRow));
        std::copy_n(begin, ridges.index(0, band.rowCount),
                    inverted.pixels.begin() + static_cast<std::ptrdiff_t>(inverted.index(0, band.firstRow)));
    }
    return inverted;
}

std::vector<float> valuesInside(const Mask2d& inside, const ImageF& inverted)
{
    std::vector<float> values;
    for (std::size_t i = 0; i < inverted.pixels.size(); ++i) {
        if (inside.pixels[i] != 0 && inverted.pixels[i] >= 0.0F) {
            values.push_back(inverted.pixels[i]);
        }
    }
    return values;
}

Mask2d excludeVessels(Mask2d inside, const ImageF& ridges, double vesselThreshold)
{
    Mask2d vessels(ridges.width, ridges.height);
    for (std::size_t i = 0; i < vessels.pixels.size(); ++i) {
        vessels.pixels[i] = ridges.pixels[i] > vesselThreshold ? 255 : 0;
    }
    vessels = dilate(vessels, flankPx);
    for (std::size_t i = 0; i < inside.pixels.size(); ++i) {
        inside.pixels[i] = vessels.pixels[i] != 0 ? 0 : inside.pixels[i];
    }
    return inside;
}

}   // namespace

ClutterEstimate::ClutterEstimate(const ImageF& opacity, const Mask2d& field, std::vector<RidgeScale> scales)
    : field_(erode(field, clutterRimPx)), scales_(std::move(scales)), inverted_(opacity.width, opacity.height, -1.0F)
{
    double coarsest = 0.0;
    for (auto scale = scales_.rbegin(); scale != scales_.rend(); ++scale) {
        const ImageF inverted = invertedRidges(opacity, *scale);
        std::vector<float> measured = valuesInside(field_, inverted);
        const double level = measured.empty() ? 0.0 : grayQuantile(std::move(measured), clutterQuantile);
        coarsest = scale == scales_.rbegin() ? level : coarsest;
        scale->weight = level > coarsest ? std::max(minWeight, coarsest / level) : 1.0;
        const auto weight = static_cast<float>(scale->weight);
        std::transform(inverted_.pixels.begin(), inverted_.pixels.end(), inverted.pixels.begin(),
                       inverted_.pixels.begin(), [weight](float a, float b) { return std::max(a, weight * b); });
    }
}

double ClutterEstimate::level(const ImageF& ridges) const
{
    std::vector<float> allValues = valuesInside(field_, inverted_);
    if (allValues.empty()) {
        return 0.0;
    }
    const std::size_t minCount = allValues.size() / minRemainderDivisor;
    const double first = grayQuantile(std::move(allValues), clutterQuantile);
    std::vector<float> distantValues = valuesInside(excludeVessels(field_, ridges, clearMultiple * first), inverted_);
    if (distantValues.size() <= minCount) {
        return first;
    }
    const std::vector<float> levels = grayQuantiles(std::move(distantValues), {clutterQuantile, tailQuantile});
    return std::min<double>(levels[0], levels[1] / tailRatio);
}

}   // namespace angiopose::core
