#include "core/tracing/angiogram/ridges/vessel_threshold.h"

#include "core/imaging/gray_statistics.h"
#include "core/imaging/image_filters.h"
#include "core/imaging/mask_morphology.h"

#include <algorithm>

namespace angiopose::core {
namespace {

constexpr float lowEvidence = 0.9F;
constexpr float highEvidence = 1.9F;
constexpr int flankReachPx = 3;
constexpr float flankFraction = 0.35F;
// Radius of the halo in which filters still respond weakly to the ends of strong vessels.
constexpr int haloReachPx = 12;
constexpr float haloFraction = 0.15F;
constexpr double opacitySigmaPx = 2.0;
constexpr float minOpacityPerRidge = 0.3F;   // the opacity of a round vessel is a few times its ridge strength
constexpr std::size_t thresholdSamples = 200000;
constexpr double noiseMultiple = 4.0;
constexpr double clutterMultiple = 1.9;
// Lower limit relative to the strongest ridges, for images without noise: weaker ridges are filter artifacts.
constexpr double minRelativeStrength = 0.02;
constexpr double strongestQuantile = 0.999;

}   // namespace

double ridgeNoiseLimit(const std::vector<float>& ridges)
{
    return ridges.empty() ? 0.0 : noiseMultiple * grayQuantile(ridges, 0.5);
}

double vesselThreshold(const ImageF& ridges, double clutter, double sensitivity)
{
    const double strongest = grayQuantile(subsample(ridges.pixels, thresholdSamples), strongestQuantile);
    return std::max(clutterMultiple * clutter, minRelativeStrength * strongest) / sensitivity;
}

ImageF vesselEvidence(const ImageF& ridges, const Mask2d& field, double vesselThreshold)
{
    ImageF evidence(ridges.width, ridges.height);
    if (!(vesselThreshold > 0.0)) {
        return evidence;
    }
    const auto unit = static_cast<float>(vesselThreshold);
    for (std::size_t i = 0; i < ridges.pixels.size(); ++i) {
        evidence.pixels[i] = field.pixels[i] != 0 ? ridges.pixels[i] / unit : 0.0F;
    }
    return evidence;
}

ImageF removeStarArtifacts(ImageF ridges, const ImageF& opacity)
{
    const ImageF smooth = gaussianBlur(opacity, opacitySigmaPx);
    for (std::size_t i = 0; i < ridges.pixels.size(); ++i) {
        ridges.pixels[i] = smooth.pixels[i] < minOpacityPerRidge * ridges.pixels[i] ? 0.0F : ridges.pixels[i];
    }
    return ridges;
}

Mask2d segmentVessels(const ImageF& evidence)
{
    const ImageF strongest = maximumFilter(evidence, flankReachPx);
    const ImageF strongestInHalo = maximumFilter(evidence, haloReachPx);
    Mask2d vessels(evidence.width, evidence.height);
    for (std::size_t i = 0; i < evidence.pixels.size(); ++i) {
        const float minEvidence =
            std::max({lowEvidence, flankFraction * strongest.pixels[i], haloFraction * strongestInHalo.pixels[i]});
        vessels.pixels[i] = evidence.pixels[i] > minEvidence ? 255 : 0;
    }
    for (const std::vector<std::size_t>& component : componentsOf(vessels)) {
        const bool isVessel = std::any_of(component.begin(), component.end(),
                                          [&](std::size_t p) { return evidence.pixels[p] > highEvidence; });
        for (const std::size_t p : component) {
            vessels.pixels[p] = isVessel ? 255 : 0;
        }
    }
    return vessels;
}

}   // namespace angiopose::core
