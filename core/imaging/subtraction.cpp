#include "core/imaging/subtraction.h"

#include "core/imaging/gray_statistics.h"
#include "core/imaging/image_filters.h"
#include "core/imaging/wide_gaussian_blur.h"
#include "core/support/symmetric.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace angiopose::core {
namespace {

constexpr std::size_t subtractionSamples = 100000;
constexpr double slowSigmaFraction = 0.03;   // σ of slow differences between images (exposure), as a share of the side
constexpr int minPyramidSide = 48;   // minimum image side in the resolution pyramid, px
constexpr int roundsPerLevel = 20;
constexpr double shiftTolerancePx = 1e-3;
constexpr double madToSigma = 1.4826;
constexpr double maxShiftFraction = 0.1;

/// Returns the image in logarithmic values, in which contrast agent is additive.
ImageF logarithmic(const ImageF& image, PixelRelation relation)
{
    if (relation == PixelRelation::Logarithmic) {
        return image;
    }
    ImageF result = image;
    for (float& value : result.pixels) {
        value = std::log(std::max(value, 1.0F));
    }
    return result;
}

ImageF highPassFiltered(ImageF image)
{
    const ImageF slow = wideGaussianBlur(image, slowSigmaFraction * std::max(image.width, image.height));
    std::transform(image.pixels.begin(), image.pixels.end(), slow.pixels.begin(), image.pixels.begin(),
                   [](float value, float mean) { return value - mean; });
    return gaussianBlur(image, 1.0);
}

/// One pixel of the least-squares problem: its residual and the mask gradient at its source position.
struct Sample {
    float residual;
    float slopeX;
    float slopeY;
};

std::vector<Sample> samplesAt(const ImageF& mask, const ImageF& frame, const Eigen::Vector2d& shift)
{
    const int marginX = static_cast<int>(std::ceil(std::abs(shift.x()))) + 2;
    const int marginY = static_cast<int>(std::ceil(std::abs(shift.y()))) + 2;
    std::vector<Sample> samples;
    for (int y = marginY; y < frame.height - marginY; ++y) {
        for (int x = marginX; x < frame.width - marginX; ++x) {
            const double fromX = x - shift.x();
            const double fromY = y - shift.y();
            samples.push_back(
                {frame.at(x, y) - sampleBilinear(mask, fromX, fromY),
                 0.5F * (sampleBilinear(mask, fromX + 1.0, fromY) - sampleBilinear(mask, fromX - 1.0, fromY)),
                 0.5F * (sampleBilinear(mask, fromX, fromY + 1.0) - sampleBilinear(mask, fromX, fromY - 1.0))});
        }
    }
    return samples;
}

double robustScale(const std::vector<Sample>& samples)
{
    std::vector<float> sizes;
    sizes.reserve(samples.size());
    for (const Sample& sample : samples) {
        sizes.push_back(std::abs(sample.residual));
    }
    return madToSigma * grayQuantile(subsample(sizes, subtractionSamples), 0.5);
}

/// Returns the Gauss–Newton step of the shift; zero if the gradients are all zero or all have the same direction.
Eigen::Vector2d shiftStep(const std::vector<Sample>& samples)
{
    const double scale = std::max(robustScale(samples), 1e-9);
    Eigen::Matrix2d normal = Eigen::Matrix2d::Zero();
    Eigen::Vector2d right = Eigen::Vector2d::Zero();
    for (const Sample& sample : samples) {
        const double ratio = sample.residual / (2.0 * scale);
        const double weight = std::exp(-0.5 * ratio * ratio);
        const Eigen::Vector2d slope(sample.slopeX, sample.slopeY);
        normal += weight * slope * slope.transpose();
        right -= weight * slope * static_cast<double>(sample.residual);   // a right shift samples the mask farther left
    }
    const EigenDecomposition<2> axes = eigenDecomposition(normal);
    if (axes.values[0] <= 1e-6 * axes.values[1] || axes.values[1] <= 0.0) {
        return Eigen::Vector2d::Zero();
    }
    return axes.directions * (axes.directions.transpose() * right).cwiseQuotient(axes.values);
}

Eigen::Vector2d refineShift(const ImageF& mask, const ImageF& frame, Eigen::Vector2d shift)
{
    const double maxShiftNormPx = maxShiftFraction * std::min(frame.width, frame.height);
    for (int round = 0; round < roundsPerLevel; ++round) {
        const std::vector<Sample> samples = samplesAt(mask, frame, shift);
        if (samples.empty()) {
            break;
        }
        const Eigen::Vector2d step = shiftStep(samples);
        const Eigen::Vector2d next = shift + step;
        if (!(next.norm() <= maxShiftNormPx)) {
            break;
        }
        shift = next;
        if (step.norm() < shiftTolerancePx) {
            break;
        }
    }
    return shift;
}

}   // namespace

ImageF meanFrame(const std::vector<ImageF>& frames, const std::vector<int>& indices)
{
    ImageF mean;
    for (const int index : indices) {
        const ImageF& frame = frames[static_cast<std::size_t>(index)];
        if (mean.isEmpty()) {
            mean = ImageF(frame.width, frame.height);
        }
        assert(frame.pixels.size() == mean.pixels.size());
        for (std::size_t i = 0; i < mean.pixels.size(); ++i) {
            mean.pixels[i] += frame.pixels[i] / static_cast<float>(indices.size());
        }
    }
    return mean;
}

Eigen::Vector2d findMaskShift(const ImageF& mask, const ImageF& frame, PixelRelation relation)
{
    assert(mask.width == frame.width && mask.height == frame.height);
    std::vector<ImageF> masks{highPassFiltered(logarithmic(mask, relation))};
    std::vector<ImageF> frames{highPassFiltered(logarithmic(frame, relation))};
    while (std::min(frames.back().width, frames.back().height) >= 2 * minPyramidSide) {
        masks.push_back(halveSize(masks.back()));
        frames.push_back(halveSize(frames.back()));
    }
    Eigen::Vector2d shift = Eigen::Vector2d::Zero();
    for (std::size_t level = frames.size(); level-- > 0;) {
        shift = refineShift(masks[level], frames[level], level + 1 < frames.size() ? 2.0 * shift : shift);
    }
    return shift;
}

ImageF subtracted(const ImageF& frame, const ImageF& mask, const Eigen::Vector2d& shiftPx, PixelRelation relation)
{
    assert(mask.width == frame.width && mask.height == frame.height);
    const ImageF logFrame = logarithmic(frame, relation);
    const ImageF logMask = logarithmic(mask, relation);
    const float middle = frame.isEmpty() ? 0.0F : grayQuantile(subsample(frame.pixels, subtractionSamples), 0.5);
    const float gain = relation == PixelRelation::Linear ? std::max(middle, 1.0F) : 1.0F;
    ImageF result(frame.width, frame.height);
    for (int y = 0; y < frame.height; ++y) {
        for (int x = 0; x < frame.width; ++x) {
            const float below = sampleBilinear(logMask, x - shiftPx.x(), y - shiftPx.y());
            result.at(x, y) = middle + gain * (logFrame.at(x, y) - below);
        }
    }
    return result;
}

ImageF peakOpacificationImage(const std::vector<ImageF>& frames, Polarity polarity)
{
    if (frames.empty()) {
        return {};
    }
    ImageF composite = frames.front();
    for (const ImageF& frame : frames) {
        if (frame.width != composite.width || frame.height != composite.height) {
            continue;
        }
        std::transform(frame.pixels.begin(), frame.pixels.end(), composite.pixels.begin(), composite.pixels.begin(),
                       [polarity](float a, float b) {
                           return polarity == Polarity::VesselsDark ? std::min(a, b) : std::max(a, b);
                       });
    }
    return composite;
}

}   // namespace angiopose::core
