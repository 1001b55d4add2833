#include "core/tracing/angiogram/evidence/network_input.h"

#include "core/imaging/grey_statistics.h"
#include "core/imaging/image_filters.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace angiopose::core {
namespace {

constexpr double mostAreaPx = 384.0 * 384.0;   // what two cores manage in 100 ms
constexpr int cellPx = 16;
constexpr double surroundingsSigmaPx = 16.0;
constexpr float leastSpreadShare = 0.25F;
constexpr float mostLocalGrey = 4.0F;

/// Which pixels make one of the new ones, and with what weights.
struct Taps {
    int first = 0;
    std::vector<float> weights;
};

Taps areaTaps(int i, double scale, int count)
{
    const double from = i * scale;
    const double to = std::min<double>(count, from + scale);
    Taps taps{std::min(count - 1, static_cast<int>(from)), {}};
    for (int k = taps.first; k < count && k < to; ++k) {
        taps.weights.push_back(static_cast<float>((std::min(to, k + 1.0) - std::max(from, 1.0 * k)) / (to - from)));
    }
    return taps;
}

Taps linearTaps(int i, double scale, int count)
{
    const double at = std::clamp((i + 0.5) * scale - 0.5, 0.0, count - 1.0);
    const int first = std::min(static_cast<int>(at), std::max(0, count - 2));
    const auto share = static_cast<float>(at - first);
    return count < 2 ? Taps{0, {1.0F}} : Taps{first, {1.0F - share, share}};
}

std::vector<Taps> tapsOf(int from, int to)
{
    const double scale = static_cast<double>(from) / to;
    std::vector<Taps> taps;
    for (int i = 0; i < to; ++i) {
        taps.push_back(scale > 1.0 ? areaTaps(i, scale, from) : linearTaps(i, scale, from));
    }
    return taps;
}

/// Each row with other columns, and turned: twice gives both.
ImageF withOtherColumns(const ImageF& image, int width)
{
    const std::vector<Taps> taps = tapsOf(image.width, width);
    ImageF turned(image.height, width);
    for (int y = 0; y < image.height; ++y) {
        const float* row = &image.at(0, y);
        for (int x = 0; x < width; ++x) {
            const Taps& tap = taps[static_cast<std::size_t>(x)];
            turned.at(y, x) = std::inner_product(tap.weights.begin(), tap.weights.end(), row + tap.first, 0.0F);
        }
    }
    return turned;
}

ImageF againstSurroundings(const ImageF& frame)
{
    const ImageF surroundings = blurred(frame, surroundingsSigmaPx);
    ImageF difference = frame;
    ImageF squares = frame;
    for (std::size_t i = 0; i < frame.pixels.size(); ++i) {
        difference.pixels[i] -= surroundings.pixels[i];
        squares.pixels[i] = difference.pixels[i] * difference.pixels[i];
    }
    ImageF spread = blurred(squares, surroundingsSigmaPx);
    double sum = 0.0;
    for (float& value : spread.pixels) {
        value = std::sqrt(std::max(0.0F, value));
        sum += value;
    }
    const auto least = static_cast<float>(sum / static_cast<double>(spread.pixels.size())) * leastSpreadShare + 1e-6F;
    for (std::size_t i = 0; i < frame.pixels.size(); ++i) {
        difference.pixels[i] =
            std::clamp(difference.pixels[i] / (spread.pixels[i] + least), -mostLocalGrey, mostLocalGrey);
    }
    return difference;
}

ImageF withinWhole(ImageF frame)
{
    const std::vector<float> ends = rankedAt(frame.pixels, {0.02, 0.98});
    const float range = ends[1] - ends[0] + 1e-6F;
    for (float& value : frame.pixels) {
        value = std::clamp((value - ends[0]) / range - 0.5F, -1.0F, 1.0F);
    }
    return frame;
}

int wholeCells(int count)
{
    return (count + cellPx - 1) / cellPx * cellPx;
}

void appendPadded(NetworkInput& input, const ImageF& channel)
{
    for (int y = 0; y < input.paddedHeight; ++y) {
        const float* row = &channel.at(0, std::min(y, channel.height - 1));
        input.values.insert(input.values.end(), row, row + channel.width);
        input.values.insert(input.values.end(), static_cast<std::size_t>(input.paddedWidth - channel.width),
                            row[channel.width - 1]);
    }
}

}   // namespace

ImageF resampled(const ImageF& image, int width, int height)
{
    if (image.width == width && image.height == height) {
        return image;
    }
    return withOtherColumns(withOtherColumns(image, width), height);
}

NetworkInput networkInput(const ImageF& vesselsDark)
{
    const double area = static_cast<double>(vesselsDark.width) * vesselsDark.height;
    const double scale = std::min(1.0, std::sqrt(mostAreaPx / area));
    const auto scaled = [&](int side) { return std::max(1, static_cast<int>(std::lround(scale * side))); };
    const ImageF frame = resampled(vesselsDark, scaled(vesselsDark.width), scaled(vesselsDark.height));
    NetworkInput input{frame.width, frame.height, wholeCells(frame.width), wholeCells(frame.height), {}};
    appendPadded(input, againstSurroundings(frame));
    appendPadded(input, withinWhole(frame));
    return input;
}

}   // namespace angiopose::core
