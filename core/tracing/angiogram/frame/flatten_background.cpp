#include "core/tracing/angiogram/frame/flatten_background.h"

#include "core/imaging/gray_statistics.h"
#include "core/imaging/image_filters.h"
#include "core/support/parallel_for.h"

#include <algorithm>
#include <cmath>

namespace angiopose::core {
namespace {

// Exponent of the vessel contrast as a function of background brightness: 1 for a fixed fraction of the background
// (Beer-Lambert), 0 for a fixed difference; display curves lie in between.
constexpr double contrastPower = 0.65;
constexpr float vesselWeight = 0.05F;
constexpr float minRelativeBackground = 0.3F;   // fraction of the median background; lower values would amplify noise

/// Returns the weighted Gaussian mean, Σ w v / Σ w, on a coarser grid; only variations slower than `sigmaPx` matter.
ImageF weightedBlur(const ImageF& values, const ImageF& weights, double sigmaPx)
{
    ImageF weighted = values;
    for (std::size_t i = 0; i < weighted.pixels.size(); ++i) {
        weighted.pixels[i] *= weights.pixels[i];
    }
    ImageF mass = weights;
    int factor = 1;
    while (sigmaPx / factor > 4.0 && std::min(mass.width, mass.height) > 1) {
        weighted = halveSize(weighted);
        mass = halveSize(mass);
        factor *= 2;
    }
    runInParallel([&] { weighted = gaussianBlur(weighted, sigmaPx / factor); },
                  [&] { mass = gaussianBlur(mass, sigmaPx / factor); });
    for (std::size_t i = 0; i < weighted.pixels.size(); ++i) {
        weighted.pixels[i] = mass.pixels[i] > 1e-6F ? weighted.pixels[i] / mass.pixels[i] : 0.0F;
    }
    return upsample(weighted, factor, values.width, values.height);
}

/// Estimates the background. Pixels darker than the background by more than the spread hardly count, because vessels
/// must not darken it.
ImageF estimateBackground(const ImageF& image, const ImageF& exposed, double sigmaPx)
{
    const ImageF first = weightedBlur(image, exposed, sigmaPx);
    double sum = 0.0;
    double count = 0.0;
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        const double difference = first.pixels[i] - image.pixels[i];
        sum += exposed.pixels[i] * difference * difference;
        count += exposed.pixels[i];
    }
    const double spread = count > 0.0 ? std::sqrt(sum / count) : 0.0;
    ImageF weights = exposed;
    for (std::size_t i = 0; i < weights.pixels.size(); ++i) {
        weights.pixels[i] *= first.pixels[i] - image.pixels[i] > spread ? vesselWeight : 1.0F;
    }
    return weightedBlur(image, weights, sigmaPx);
}

/// Returns the gain that scales differences from the background to their value at the median background.
ImageF contrastGain(const ImageF& background, const ImageF& exposed, float black)
{
    std::vector<float> levels;
    for (std::size_t i = 0; i < exposed.pixels.size(); ++i) {
        if (exposed.pixels[i] > 0.0F) {
            levels.push_back(background.pixels[i] - black);
        }
    }
    ImageF gain(background.width, background.height, 1.0F);
    const float middle = levels.empty() ? 0.0F : grayQuantile(std::move(levels), 0.5);
    if (middle > 0.0F) {
        for (std::size_t i = 0; i < gain.pixels.size(); ++i) {
            const float level = std::max(minRelativeBackground, (background.pixels[i] - black) / middle);
            gain.pixels[i] = std::pow(level, static_cast<float>(-contrastPower));
        }
    }
    return gain;
}

}   // namespace

ImageF flattenBackground(const ImageF& vesselsDark, const Mask2d& field, double reachPx)
{
    ImageF exposed(vesselsDark.width, vesselsDark.height);
    for (std::size_t i = 0; i < exposed.pixels.size(); ++i) {
        exposed.pixels[i] = field.pixels[i] != 0 ? 1.0F : 0.0F;
    }
    const ImageF coarseExposed = halveSize(exposed);
    const ImageF coarse = estimateBackground(halveSize(vesselsDark), coarseExposed, 0.5 * reachPx);
    const float black = *std::min_element(vesselsDark.pixels.begin(), vesselsDark.pixels.end());
    ImageF background;
    ImageF gain;
    runInParallel([&] { gain = upsample(contrastGain(coarse, coarseExposed, black), 2, field.width, field.height); },
                  [&] { background = upsample(coarse, 2, field.width, field.height); });
    ImageF opacity(vesselsDark.width, vesselsDark.height);
    for (std::size_t i = 0; i < opacity.pixels.size(); ++i) {
        opacity.pixels[i] = exposed.pixels[i] * gain.pixels[i] * (background.pixels[i] - vesselsDark.pixels[i]);
    }
    return opacity;
}

}   // namespace angiopose::core
