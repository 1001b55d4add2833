#include "core/imaging/image_filters.h"

#include "core/imaging/window_maximum.h"
#include "core/support/parallel_for.h"
#include "core/support/wide_vectors.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace angiopose::core {
namespace {

/// Returns half of a symmetric kernel: the weights at distance 0, 1, 2, …. The full kernel sums to one.
std::vector<float> gaussianHalfKernel(double sigmaPx)
{
    const int reach = static_cast<int>(std::ceil(3.0 * sigmaPx));
    std::vector<double> weights;
    weights.reserve(static_cast<std::size_t>(reach) + 1);
    double sum = 0.0;
    for (int i = 0; i <= reach; ++i) {
        weights.push_back(std::exp(-0.5 * i * i / (sigmaPx * sigmaPx)));
        sum += i == 0 ? weights.back() : 2.0 * weights.back();
    }
    std::vector<float> kernel;
    kernel.reserve(weights.size());
    for (const double weight : weights) {
        kernel.push_back(static_cast<float>(weight / sum));
    }
    return kernel;
}

/// Computes target += weight (a + b), element-wise.
ANGIOPOSE_WIDE_VECTORS
void addWeighted(float* target, const float* a, const float* b, float weight, int count)
{
    for (int i = 0; i < count; ++i) {
        target[i] += weight * (a[i] + b[i]);
    }
}

/// Computes target = max(target, values), element-wise.
ANGIOPOSE_WIDE_VECTORS
void elementwiseMax(float* target, const float* values, int count)
{
    for (int i = 0; i < count; ++i) {
        target[i] = target[i] > values[i] ? target[i] : values[i];
    }
}

void blurRow(const float* source, float* target, int width, const std::vector<float>& kernel,
             std::vector<float>& padded)
{
    const int reach = static_cast<int>(kernel.size()) - 1;
    padded.assign(static_cast<std::size_t>(width) + 2 * (kernel.size() - 1), source[0]);
    std::copy(source, source + width, padded.begin() + reach);
    std::fill(padded.begin() + reach + width, padded.end(), source[width - 1]);
    const float* center = padded.data() + reach;
    for (int x = 0; x < width; ++x) {
        target[x] = kernel[0] * center[x];
    }
    for (int i = 1; i <= reach; ++i) {
        addWeighted(target, center - i, center + i, kernel[static_cast<std::size_t>(i)], width);
    }
}

void blurColumns(const ImageF& source, int y, float* target, const std::vector<float>& kernel)
{
    const float* center = &source.pixels[source.index(0, y)];
    for (int x = 0; x < source.width; ++x) {
        target[x] = kernel[0] * center[x];
    }
    for (int i = 1; i < static_cast<int>(kernel.size()); ++i) {
        const float weight = kernel[static_cast<std::size_t>(i)];
        const float* above = &source.pixels[source.index(0, std::max(0, y - i))];
        const float* below = &source.pixels[source.index(0, std::min(source.height - 1, y + i))];
        addWeighted(target, above, below, weight, source.width);
    }
}

/// Calls `work` for all rows, in bands distributed over the threads.
template <class Work>
void forEachBand(int rowCount, int threads, const Work& work)
{
    if (threads <= 1) {
        work(0, rowCount);
        return;
    }
    const auto edge = [&](std::size_t strip) { return static_cast<int>(strip) * rowCount / threads; };
    parallelFor(
        static_cast<std::size_t>(threads), threads, [&](std::size_t strip) { work(edge(strip), edge(strip + 1)); },
        [](double) { return true; });
}

}   // namespace

ImageF gaussianBlur(const ImageF& image, double sigmaPx, int threads)
{
    if (sigmaPx <= 0.0 || image.isEmpty()) {
        return image;
    }
    const std::vector<float> kernel = gaussianHalfKernel(sigmaPx);
    ImageF rows(image.width, image.height);
    forEachBand(image.height, threads, [&](int top, int bottom) {
        std::vector<float> padded;
        for (int y = top; y < bottom; ++y) {
            blurRow(&image.at(0, y), &rows.at(0, y), image.width, kernel, padded);
        }
    });
    ImageF result(image.width, image.height);
    forEachBand(image.height, threads, [&](int top, int bottom) {
        for (int y = top; y < bottom; ++y) {
            blurColumns(rows, y, &result.at(0, y), kernel);
        }
    });
    return result;
}

ImageF maximumFilter(const ImageF& image, int radiusPx)
{
    return windowMaximum(image, radiusPx, elementwiseMax);
}

ImageF halveSize(const ImageF& image)
{
    ImageF half((image.width + 1) / 2, (image.height + 1) / 2);
    for (int y = 0; y < half.height; ++y) {
        const int below = std::min(2 * y + 1, image.height - 1);
        for (int x = 0; x < half.width; ++x) {
            const int right = std::min(2 * x + 1, image.width - 1);
            half.at(x, y) = 0.25F * (image.at(2 * x, 2 * y) + image.at(right, 2 * y) + image.at(2 * x, below) +
                                     image.at(right, below));
        }
    }
    return half;
}

ImageF upsample(const ImageF& image, int factor, int width, int height)
{
    assert(!image.isEmpty() && factor >= 1);
    struct Tap {
        int first;
        int second;
        float fraction;
    };
    const auto tap = [factor](int position, int size) {
        const float source = (static_cast<float>(position) + 0.5F) / static_cast<float>(factor) - 0.5F;
        const float inside = std::clamp(source, 0.0F, static_cast<float>(size - 1));
        const int first = static_cast<int>(inside);
        return Tap{first, std::min(first + 1, size - 1), inside - static_cast<float>(first)};
    };
    std::vector<Tap> columns;
    columns.reserve(static_cast<std::size_t>(width));
    for (int x = 0; x < width; ++x) {
        columns.push_back(tap(x, image.width));
    }
    ImageF result(width, height);
    std::vector<float> mixed(static_cast<std::size_t>(image.width));
    for (int y = 0; y < height; ++y) {
        const Tap row = tap(y, image.height);
        for (int x = 0; x < image.width; ++x) {
            const float upper = image.at(x, row.first);
            mixed[static_cast<std::size_t>(x)] = upper + row.fraction * (image.at(x, row.second) - upper);
        }
        for (int x = 0; x < width; ++x) {
            const Tap& column = columns[static_cast<std::size_t>(x)];
            const float left = mixed[static_cast<std::size_t>(column.first)];
            result.at(x, y) = left + column.fraction * (mixed[static_cast<std::size_t>(column.second)] - left);
        }
    }
    return result;
}

float sampleBilinear(const ImageF& image, double x, double y)
{
    const double insideX = std::clamp(x, 0.0, image.width - 1.0);
    const double insideY = std::clamp(y, 0.0, image.height - 1.0);
    const int left = static_cast<int>(insideX);
    const int top = static_cast<int>(insideY);
    const int right = std::min(left + 1, image.width - 1);
    const int bottom = std::min(top + 1, image.height - 1);
    const auto fx = static_cast<float>(insideX - left);
    const auto fy = static_cast<float>(insideY - top);
    const float upper = image.at(left, top) + fx * (image.at(right, top) - image.at(left, top));
    const float lower = image.at(left, bottom) + fx * (image.at(right, bottom) - image.at(left, bottom));
    return upper + fy * (lower - upper);
}

}   // namespace angiopose::core
