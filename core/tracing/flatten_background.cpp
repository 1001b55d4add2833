#include "core/tracing/flatten_background.h"

#include "core/imaging/image_filters.h"

#include <algorithm>
#include <cmath>

namespace core {
namespace {

/// Weighted Gaussian mean, sum(w v)/sum(w), on a coarse grid: only what varies slower than `sigmaPx` is wanted.
ImageF slowMean(const ImageF& values, const ImageF& weights, double sigmaPx)
{
    ImageF weighted = values;
    for (std::size_t i = 0; i < weighted.pixels.size(); ++i) {
        weighted.pixels[i] *= weights.pixels[i];
    }
    ImageF mass = weights;
    int factor = 1;
    while (sigmaPx / factor > 4.0 && std::min(mass.width, mass.height) > 1) {
        weighted = halved(weighted);
        mass = halved(mass);
        factor *= 2;
    }
    weighted = blurred(weighted, sigmaPx / factor);
    mass = blurred(mass, sigmaPx / factor);
    for (std::size_t i = 0; i < weighted.pixels.size(); ++i) {
        weighted.pixels[i] = mass.pixels[i] > 1e-6F ? weighted.pixels[i] / mass.pixels[i] : 0.0F;
    }
    return enlarged(weighted, factor, values.width, values.height);
}

double rootMeanSquare(const ImageF& opacity, const Mask2d& field)
{
    double sum = 0.0;
    double count = 0.0;
    for (std::size_t i = 0; i < opacity.pixels.size(); ++i) {
        if (field.pixels[i] != 0) {
            sum += static_cast<double>(opacity.pixels[i]) * opacity.pixels[i];
            count += 1.0;
        }
    }
    return count > 0.0 ? std::sqrt(sum / count) : 0.0;
}

ImageF darkerThan(const ImageF& background, const ImageF& image, const Mask2d& field)
{
    ImageF opacity(image.width, image.height);
    for (std::size_t i = 0; i < opacity.pixels.size(); ++i) {
        opacity.pixels[i] = field.pixels[i] != 0 ? background.pixels[i] - image.pixels[i] : 0.0F;
    }
    return opacity;
}

}   // namespace

ImageF flattenBackground(const ImageF& vesselsDark, const Mask2d& field, double reachPx)
{
    ImageF weights(vesselsDark.width, vesselsDark.height);
    for (std::size_t i = 0; i < weights.pixels.size(); ++i) {
        weights.pixels[i] = field.pixels[i] != 0 ? 1.0F : 0.0F;
    }
    const ImageF first = darkerThan(slowMean(vesselsDark, weights, reachPx), vesselsDark, field);
    // The vessels themselves must not darken the background: leave out what the first estimate shows as vessel.
    const auto vesselLike = static_cast<float>(rootMeanSquare(first, field));
    for (std::size_t i = 0; i < weights.pixels.size(); ++i) {
        if (first.pixels[i] > vesselLike) {
            weights.pixels[i] *= 0.05F;
        }
    }
    return darkerThan(slowMean(vesselsDark, weights, reachPx), vesselsDark, field);
}

}   // namespace core
