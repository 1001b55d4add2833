#include "core/tracing/vessel_threshold.h"

#include "core/imaging/grey_statistics.h"
#include "core/imaging/mask_morphology.h"

#include <algorithm>

namespace core {
namespace {

constexpr float lowEvidence = 0.9F;
constexpr float highEvidence = 1.5F;
constexpr std::size_t sampleSize = 200000;
constexpr double noiseMultiple = 4.0;

}   // namespace

double ridgeNoiseLimit(const std::vector<float>& ridges)
{
    return ridges.empty() ? 0.0 : noiseMultiple * ranked(ridges, 0.5);
}

ImageF vesselEvidence(const ImageF& ridges, const Mask2d& field, double sensitivity)
{
    std::vector<float> exposed;
    for (std::size_t i = 0; i < ridges.pixels.size(); ++i) {
        if (field.pixels[i] != 0) {
            exposed.push_back(ridges.pixels[i]);
        }
    }
    exposed = evenSample(exposed, sampleSize);
    ImageF evidence(ridges.width, ridges.height);
    const double threshold = std::max<double>(otsuThreshold(exposed), ridgeNoiseLimit(exposed)) / sensitivity;
    if (!(threshold > 0.0)) {
        return evidence;
    }
    for (std::size_t i = 0; i < ridges.pixels.size(); ++i) {
        evidence.pixels[i] = field.pixels[i] != 0 ? ridges.pixels[i] / static_cast<float>(threshold) : 0.0F;
    }
    return evidence;
}

Mask2d vesselPixels(const ImageF& evidence)
{
    Mask2d vessels(evidence.width, evidence.height);
    for (std::size_t i = 0; i < evidence.pixels.size(); ++i) {
        vessels.pixels[i] = evidence.pixels[i] > lowEvidence ? 255 : 0;
    }
    for (const std::vector<std::size_t>& component : componentsOf(vessels)) {
        const bool isSure = std::any_of(component.begin(), component.end(),
                                        [&](std::size_t p) { return evidence.pixels[p] > highEvidence; });
        for (const std::size_t p : component) {
            vessels.pixels[p] = isSure ? 255 : 0;
        }
    }
    return vessels;
}

}   // namespace core
