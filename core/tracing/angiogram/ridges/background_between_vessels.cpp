#include "core/tracing/angiogram/ridges/background_between_vessels.h"

#include "core/imaging/image_filters.h"
#include "core/imaging/mask_morphology.h"

#include <algorithm>
#include <functional>

namespace angiopose::core {
namespace {

// Finer lines are mostly noise; coarser background is already recognized by the filters for wide vessels.
constexpr double minBackgroundSigmaPx = 1.4;
constexpr double maxBackgroundSigmaPx = 2.3;
constexpr float minRidgeEvidence = 1.3F;   // slightly above the vessel threshold, so noise does not split wide vessels
constexpr float minRelativeEvidence = 0.3F;   // relative to the evidence of the adjacent vessels
constexpr int neighborReachPx = 5;
constexpr std::size_t minPixelsOfRidge = 16;   // smaller lines are texture

ImageF brightRidges(ImageF opacity, std::vector<RidgeScale> scales)
{
    std::ranges::transform(opacity.pixels, opacity.pixels.begin(), std::negate{});
    std::erase_if(scales, [](const RidgeScale& scale) {
        return scale.sigmaPx < minBackgroundSigmaPx || scale.sigmaPx > maxBackgroundSigmaPx;
    });
    return ridgeStrength(opacity, scales);
}

}   // namespace

Mask2d findBackgroundBetweenVessels(const Mask2d& vessels, const ImageF& evidence, const ImageF& opacity,
                                    const std::vector<RidgeScale>& scales, double vesselThreshold)
{
    const ImageF bright = brightRidges(opacity, scales);
    const ImageF strongestNearby = maximumFilter(evidence, neighborReachPx);
    const auto unit = static_cast<float>(vesselThreshold);
    Mask2d background(vessels.width, vessels.height);
    for (std::size_t i = 0; i < background.pixels.size(); ++i) {
        const float minRidge = unit * std::max(minRidgeEvidence, minRelativeEvidence * strongestNearby.pixels[i]);
        background.pixels[i] = vessels.pixels[i] != 0 && bright.pixels[i] > minRidge ? 255 : 0;
    }
    for (const std::vector<std::size_t>& line : componentsOf(background)) {
        for (const std::size_t p : line) {
            background.pixels[p] = line.size() < minPixelsOfRidge ? 0 : 255;
        }
    }
    return background;
}

}   // namespace angiopose::core
