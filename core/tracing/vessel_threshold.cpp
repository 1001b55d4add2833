#include "core/tracing/vessel_threshold.h"

#include "core/imaging/grey_statistics.h"
#include "core/imaging/mask_morphology.h"

#include <algorithm>

namespace core {
namespace {

// Parts of Otsu's threshold between which a ridge counts only if it goes on to a stronger one.
constexpr double lowShare = 0.9;
constexpr double highShare = 1.5;
constexpr double noiseMultiple = 4.0;

}   // namespace

double ridgeNoiseLimit(const std::vector<float>& ridges)
{
    return ridges.empty() ? 0.0 : noiseMultiple * ranked(ridges, 0.5);
}

Mask2d thresholdVessels(const ImageF& ridges, const Mask2d& field, double sensitivity)
{
    std::vector<float> exposed;
    for (std::size_t i = 0; i < ridges.pixels.size(); ++i) {
        if (field.pixels[i] != 0) {
            exposed.push_back(ridges.pixels[i]);
        }
    }
    Mask2d vessels(ridges.width, ridges.height);
    if (exposed.empty()) {
        return vessels;
    }
    const double threshold = std::max<double>(otsuThreshold(exposed), ridgeNoiseLimit(exposed)) / sensitivity;
    const auto low = static_cast<float>(lowShare * threshold);
    const auto high = static_cast<float>(highShare * threshold);
    for (std::size_t i = 0; i < ridges.pixels.size(); ++i) {
        vessels.pixels[i] = field.pixels[i] != 0 && ridges.pixels[i] > low ? 255 : 0;
    }
    for (const std::vector<std::size_t>& component : componentsOf(vessels)) {
        if (std::none_of(component.begin(), component.end(), [&](std::size_t p) { return ridges.pixels[p] > high; })) {
            for (const std::size_t p : component) {
                vessels.pixels[p] = 0;
            }
        }
    }
    return vessels;
}

}   // namespace core
