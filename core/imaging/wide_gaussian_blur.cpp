#include "core/imaging/wide_gaussian_blur.h"

#include "core/imaging/image_filters.h"

#include <cmath>

namespace angiopose::core {

ImageF wideGaussianBlur(const ImageF& image, double sigmaPx)
{
    ImageF reduced = image;
    int factor = 1;
    while (sigmaPx / factor > 8.0) {
        reduced = halveSize(reduced);
        factor *= 2;
    }
    if (factor == 1) {
        return gaussianBlur(image, sigmaPx);
    }
    // Block averaging and bilinear enlargement also blur; their variances are therefore subtracted from σ².
    const double pixel = factor;
    const double resizeVariance = (pixel * pixel - 1.0) / 12.0 + pixel * pixel / 6.0;
    const double remainingSigmaPx = std::sqrt(sigmaPx * sigmaPx - resizeVariance) / pixel;
    return upsample(gaussianBlur(reduced, remainingSigmaPx), factor, image.width, image.height);
}

}   // namespace angiopose::core
