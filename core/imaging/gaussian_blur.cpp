#include "core/imaging/gaussian_blur.h"

#include <algorithm>
#include <cmath>

namespace core {
namespace {

constexpr double widestDirectSigmaPx = 4.0;

std::vector<float> gaussianKernel(double sigmaPx)
{
    const int reach = static_cast<int>(std::ceil(3.5 * sigmaPx));
    std::vector<float> kernel(2 * static_cast<std::size_t>(reach) + 1);
    double sum = 0.0;
    for (int i = -reach; i <= reach; ++i) {
        sum += std::exp(-0.5 * i * i / (sigmaPx * sigmaPx));
    }
    for (int i = -reach; i <= reach; ++i) {
        kernel[static_cast<std::size_t>(i + reach)] =
            static_cast<float>(std::exp(-0.5 * i * i / (sigmaPx * sigmaPx)) / sum);
    }
    return kernel;
}

ImageF transposed(const ImageF& image)
{
    ImageF result(image.height, image.width);
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            result.at(y, x) = image.at(x, y);
        }
    }
    return result;
}

/// One row with `reach` repeated border pixels on both sides.
void padRow(const float* row, int width, int reach, std::vector<float>& padded)
{
    padded.resize(static_cast<std::size_t>(width) + 2 * static_cast<std::size_t>(reach));
    std::fill_n(padded.begin(), reach, row[0]);
    std::copy_n(row, width, padded.begin() + reach);
    std::fill_n(padded.begin() + reach + width, reach, row[width - 1]);
}

void convolveRows(ImageF& image, const std::vector<float>& kernel)
{
    const int reach = static_cast<int>(kernel.size() / 2);
    std::vector<float> padded;
    for (int y = 0; y < image.height; ++y) {
        float* row = &image.at(0, y);
        padRow(row, image.width, reach, padded);
        std::fill_n(row, image.width, 0.0F);
        for (std::size_t k = 0; k < kernel.size(); ++k) {
            for (int x = 0; x < image.width; ++x) {
                row[x] += kernel[k] * padded[static_cast<std::size_t>(x) + k];
            }
        }
    }
}

void boxFilterRows(ImageF& image, int reach)
{
    const int size = 2 * reach + 1;
    std::vector<float> padded;
    for (int y = 0; y < image.height; ++y) {
        float* row = &image.at(0, y);
        padRow(row, image.width, reach, padded);
        double sum = 0.0;
        for (int k = 0; k < size - 1; ++k) {
            sum += padded[static_cast<std::size_t>(k)];
        }
        for (int x = 0; x < image.width; ++x) {
            sum += padded[static_cast<std::size_t>(x + size - 1)];
            row[x] = static_cast<float>(sum / size);
            sum -= padded[static_cast<std::size_t>(x)];
        }
    }
}

void blurRows(ImageF& image, double sigmaPx)
{
    if (sigmaPx <= widestDirectSigmaPx) {
        convolveRows(image, gaussianKernel(sigmaPx));
        return;
    }
    // A box of width w has the variance (w² − 1) / 12; the passes share out what is left of σ².
    double leftVariance = sigmaPx * sigmaPx;
    for (int passesLeft = 3; passesLeft > 0; --passesLeft) {
        const double width = std::sqrt(12.0 * leftVariance / passesLeft + 1.0);
        const int reach = static_cast<int>(std::lround(0.5 * (width - 1.0)));
        boxFilterRows(image, reach);
        leftVariance -= reach * (reach + 1.0) / 3.0;
    }
}

}   // namespace

ImageF gaussianBlurred(const ImageF& image, double sigmaPx)
{
    if (image.isEmpty() || !(sigmaPx > 0.0)) {
        return image;
    }
    ImageF result = image;
    blurRows(result, sigmaPx);
    result = transposed(result);
    blurRows(result, sigmaPx);
    return transposed(result);
}

}   // namespace core
