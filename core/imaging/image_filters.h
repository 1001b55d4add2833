#pragma once

#include "core/imaging/image2d.h"

namespace angiopose::core {

/// Returns the image smoothed with a Gaussian; edge pixels are replicated beyond the image. Returns the image unchanged
/// for `sigmaPx` ≤ 0. The result does not depend on the number of threads.
ImageF gaussianBlur(const ImageF& image, double sigmaPx, int threads = 1);

/// Returns, for each pixel, the maximum in the surrounding square of side 2·`radiusPx` + 1, clipped to the image.
ImageF maximumFilter(const ImageF& image, int radiusPx);

/// Returns the means of 2×2 pixels: pixel (i, j) lies at (2i + 0.5, 2j + 0.5) of the source. If the size is odd, the
/// last row or column is repeated.
ImageF halveSize(const ImageF& image);

/// Returns the image enlarged bilinearly by `factor` to the given size, which reverses repeated reduction by `halved`.
ImageF upsample(const ImageF& image, int factor, int width, int height);

/// Returns the bilinear sample at (x, y) px, or the nearest edge value outside the image, which must not be empty.
float sampleBilinear(const ImageF& image, double x, double y);

}   // namespace angiopose::core
