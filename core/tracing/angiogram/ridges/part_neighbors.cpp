#include "core/tracing/angiogram/ridges/part_neighbors.h"

#include "core/imaging/image_filters.h"
#include "core/imaging/mask_morphology.h"

#include <algorithm>
#include <functional>

namespace angiopose::core {
namespace {

// Finer lines are mostly noise; coarser background is already recognized by the filters for wide vessels.
constexpr double finestGroundSigmaPx = 1.4;
constexpr double coarsestGroundSigmaPx = 2.3;
constexpr float minRidgeEvidence = 1.3F;   // slightly above the vessel threshold, so noise does not split wide vessels
constexpr float minShareOfEvidence = 0.3F;   // relative to the evidence of the adjacent vessels
constexpr int neighborReachPx = 5;
constexpr std::size_t minPixelsOfRidge = 16;   // smaller lines are texture

ImageF brightRidges(ImageF opacity, std::vector<RidgeScale> scales)
{
    std::ranges::transform(opacity.pixels, opacity.pixels.begin(), std::negate{});
    std::erase_if(scales, [](const RidgeScale& scale) {
        return scale.sigmaPx < finestGroundSigmaPx || scale.sigmaPx > coarsestGroundSigmaPx;
    });
    return ridgeStrength(opacity, scales);
}

}   // namespace

Mask2d groundBetweenNeighbors(const Mask2d& vessels, const ImageF& evidence, const ImageF& opacity,
                              const std::vector<RidgeScale>& scales, double clearRidge)
{
    const ImageF bright = brightRidges(opacity, scales);
    const ImageF beside = largestAround(evidence, neighborReachPx);
    const auto unit = static_cast<float>(clearRidge);
    Mask2d ground(vessels.width, vessels.height);
    for (std::size_t i = 0; i < ground.pixels.size(); ++i) {
        const float least = unit * std::max(minRidgeEvidence, minShareOfEvidence * beside.pixels[i]);
        ground.pixels[i] = vessels.pixels[i] != 0 && bright.pixels[i] > least ? 255 : 0;
    }
    for (const std::vector<std::size_t>& line : componentsOf(ground)) {
        for (const std::size_t p : line) {
            ground.pixels[p] = line.size() < minPixelsOfRidge ? 0 : 255;
        }
    }
    return ground;
}

}   // namespace angiopose::core
