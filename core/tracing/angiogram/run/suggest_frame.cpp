#include "core/tracing/angiogram/run/suggest_frame.h"

#include "core/imaging/gray_statistics.h"
#include "core/imaging/image_filters.h"
#include "core/imaging/mask_morphology.h"
#include "core/tracing/angiogram/frame/field_mask.h"
#include "core/tracing/angiogram/frame/flatten_background.h"
#include "core/tracing/angiogram/ridges/vessel_threshold.h"
#include "core/tracing/angiogram/ridges/vesselness.h"

#include <algorithm>
#include <cmath>

namespace angiopose::core {
namespace {

// Opacification is measured on a coarse copy of each frame, because only the area of the vessels matters here.
constexpr int maxCoarseSidePx = 300;
constexpr double minRadiusPx = 1.5;
constexpr double maxRadiusPx = 4.0;
constexpr std::size_t minVesselPx = 60;
constexpr double nearPeakFraction = 0.97;   // fraction of the maximum; smaller differences are noise

bool isTraceable(const ImageF& frame, const ImageF& first)
{
    if (frame.isEmpty() || frame.width != first.width || frame.height != first.height) {
        return false;
    }
    const auto [darkest, brightest] = std::minmax_element(frame.pixels.begin(), frame.pixels.end());
    return *darkest < *brightest &&
           std::all_of(frame.pixels.begin(), frame.pixels.end(), [](float value) { return std::isfinite(value); });
}

ImageF coarseVesselsDark(const ImageF& frame, Polarity polarity)
{
    ImageF coarse = frame;
    while (std::max(coarse.width, coarse.height) > maxCoarseSidePx) {
        coarse = halveSize(coarse);
    }
    if (polarity == Polarity::VesselsBright) {
        for (float& value : coarse.pixels) {
            value = -value;
        }
    }
    return coarse;
}

double fractionAbove(const ImageF& ridges, float threshold)
{
    Mask2d above(ridges.width, ridges.height);
    for (std::size_t i = 0; i < above.pixels.size(); ++i) {
        above.pixels[i] = ridges.pixels[i] > threshold ? 255 : 0;
    }
    std::size_t count = 0;
    for (const std::vector<std::size_t>& component : componentsOf(above)) {
        count += component.size() >= minVesselPx ? component.size() : 0;   // smaller components are noise
    }
    return static_cast<double>(count) / static_cast<double>(above.pixels.size());
}

}   // namespace

std::vector<double> opacificationCurve(const std::vector<ImageF>& frames, Polarity polarity, const Mask2d& shutter)
{
    std::vector<ImageF> ridges(frames.size());
    std::vector<double> noiseLimits(frames.size(), 0.0);
    std::vector<float> pooled;
    for (std::size_t k = 0; k < frames.size(); ++k) {
        if (!isTraceable(frames[k], frames.front())) {
            continue;
        }
        const ImageF coarse = coarseVesselsDark(frames[k], polarity);
        const Mask2d field = findField(coarse, 2.0 * maxRadiusPx, shutter);
        const ImageF opacity = flattenBackground(coarse, field, 3.0 * maxRadiusPx);
        ridges[k] = ridgeStrength(opacity, minRadiusPx, maxRadiusPx);
        for (std::size_t i = 0; i < field.pixels.size(); ++i) {
            ridges[k].pixels[i] = field.pixels[i] != 0 ? ridges[k].pixels[i] : 0.0F;
        }
        noiseLimits[k] = ridgeNoiseLimit(ridges[k].pixels);
        pooled.insert(pooled.end(), ridges[k].pixels.begin(), ridges[k].pixels.end());
    }
    const double threshold = otsuThreshold(pooled);
    std::vector<double> curve;
    for (std::size_t k = 0; k < frames.size(); ++k) {
        const auto limit = static_cast<float>(std::max(threshold, noiseLimits[k]));
        curve.push_back(ridges[k].isEmpty() ? 0.0 : fractionAbove(ridges[k], limit));
    }
    return curve;
}

int suggestFrame(const std::vector<ImageF>& frames, Polarity polarity, const Mask2d& shutter)
{
    const std::vector<double> curve = opacificationCurve(frames, polarity, shutter);
    if (curve.empty()) {
        return 0;
    }
    const double peak = *std::max_element(curve.begin(), curve.end());
    std::vector<int> nearPeak;
    for (int k = 0; k < static_cast<int>(curve.size()); ++k) {
        if (curve[static_cast<std::size_t>(k)] >= nearPeakFraction * peak) {
            nearPeak.push_back(k);
        }
    }
    return nearPeak[(nearPeak.size() - 1) / 2];
}

}   // namespace angiopose::core
