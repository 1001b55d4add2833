#include "core/tracing/angiogram/frame/denoise_frame.h"

#include "core/imaging/gray_statistics.h"
#include "core/imaging/image_filters.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace angiopose::core {
namespace {

constexpr int reachFrames = 4;
constexpr int minDenoisedSidePx = 8;
constexpr double smoothingPx = 1.5;   // standard deviation of the smoothing, px of the half-size frame
// Threshold for a change, as a multiple of the standard deviation of smoothed white noise; a quarter of it is a reserve
// for detector noise that is not quite white.
constexpr double changeThreshold = 4.0;
constexpr double maxChangedFraction = 0.01;
constexpr double medianPerSigma = 0.6745;   // median of |x| for a standard normal x
constexpr std::size_t noiseSamples = 20000;

bool hasFinitePixels(const ImageF& image)
{
    return std::all_of(image.pixels.begin(), image.pixels.end(), [](float value) { return std::isfinite(value); });
}

struct Difference {
    ImageF coarse;   ///< other frame − frame, both at half size, minus `brightnessOffset`
    float brightnessOffset = 0.0F;   ///< median brightness difference, other frame minus frame
};

Difference computeDifference(const ImageF& coarse, const ImageF& other)
{
    ImageF difference = halveSize(other);
    for (std::size_t i = 0; i < difference.pixels.size(); ++i) {
        difference.pixels[i] -= coarse.pixels[i];
    }
    const float middle = grayQuantile(subsample(difference.pixels, noiseSamples), 0.5);
    for (float& value : difference.pixels) {
        value -= middle;
    }
    return {std::move(difference), middle};
}

/// Estimates the noise's standard deviation from the Laplacian (Immerkær 1996), which suppresses most anatomy.
double estimateNoise(const ImageF& image)
{
    std::vector<float> laplacian;
    for (int y = 1; y + 1 < image.height; y += 3) {
        for (int x = 1; x + 1 < image.width; ++x) {
            laplacian.push_back(std::fabs(4.0F * image.at(x, y) - image.at(x - 1, y) - image.at(x + 1, y) -
                                          image.at(x, y - 1) - image.at(x, y + 1)));
        }
    }
    return grayQuantile(std::move(laplacian), 0.5) / (medianPerSigma * std::sqrt(20.0));
}

/// Returns the mask (255) of pixels that differ only by noise, on the half-size grid; nullopt if too many have changed.
std::optional<Mask2d> unchangedPixels(const ImageF& difference)
{
    const double smoothNoise = estimateNoise(difference) / (2.0 * std::sqrt(std::numbers::pi) * smoothingPx);
    const auto limit = static_cast<float>(changeThreshold * smoothNoise);
    const ImageF smooth = gaussianBlur(difference, smoothingPx);
    Mask2d unchanged(smooth.width, smooth.height);
    std::size_t changed = 0;
    for (std::size_t i = 0; i < smooth.pixels.size(); ++i) {
        const bool isNoise = std::fabs(smooth.pixels[i]) <= limit;
        unchanged.pixels[i] = isNoise ? 255 : 0;
        changed += isNoise ? 0 : 1;
    }
    if (static_cast<double>(changed) > maxChangedFraction * static_cast<double>(smooth.pixels.size())) {
        return std::nullopt;
    }
    return unchanged;
}

struct Sum {
    ImageF values;
    ImageF counts;
};

void add(Sum& sum, const ImageF& frame, const Mask2d& unchanged, float brightnessOffset)
{
    for (int y = 0; y < frame.height; ++y) {
        for (int x = 0; x < frame.width; ++x) {
            if (unchanged.at(x / 2, y / 2) != 0) {
                sum.values.at(x, y) += frame.at(x, y) - brightnessOffset;
                sum.counts.at(x, y) += 1.0F;
            }
        }
    }
}

/// Adds the unchanged pixels of the frames on one side (`step` ±1), up to the first frame that has changed.
void addFramesOnSide(Sum& sum, const std::vector<ImageF>& frames, int index, int step, const ImageF& coarse)
{
    for (int k = 1; k <= reachFrames; ++k) {
        const int other = index + k * step;
        if (other < 0 || other >= static_cast<int>(frames.size())) {
            return;
        }
        const ImageF& frame = frames[static_cast<std::size_t>(other)];
        if (frame.width != sum.values.width || frame.height != sum.values.height || !hasFinitePixels(frame)) {
            return;
        }
        const Difference difference = computeDifference(coarse, frame);
        const auto unchanged = unchangedPixels(difference.coarse);
        if (!unchanged) {
            return;
        }
        add(sum, frame, *unchanged, difference.brightnessOffset);
    }
}

}   // namespace

ImageF denoiseFrame(const std::vector<ImageF>& frames, int index)
{
    const ImageF& frame = frames[static_cast<std::size_t>(index)];
    if (frames.size() < 2 || std::min(frame.width, frame.height) < minDenoisedSidePx || !hasFinitePixels(frame)) {
        return frame;
    }
    const ImageF coarse = halveSize(frame);
    Sum sum{frame, ImageF(frame.width, frame.height, 1.0F)};
    for (const int step : {-1, 1}) {
        addFramesOnSide(sum, frames, index, step, coarse);
    }
    for (std::size_t i = 0; i < sum.values.pixels.size(); ++i) {
        sum.values.pixels[i] /= sum.counts.pixels[i];
    }
    return std::move(sum.values);
}

}   // namespace angiopose::core
