#pragma once

#include "core/imaging/image2d.h"

namespace angiopose::core {

/// Gaussian smoothing; the image goes on as its edge pixels. `sigmaPx` ≤ 0 returns the image itself.
/// The same for any number of threads.
ImageF blurred(const ImageF& image, double sigmaPx, int threads = 1);

/// The largest value in the square of side 2·`radiusPx` + 1 around each pixel, as far as it lies in the image.
ImageF largestAround(const ImageF& image, int radiusPx);

/// Means of 2×2 pixels: pixel (i, j) lies at (2i + 0.5, 2j + 0.5) of the source. Odd last rows and columns repeat.
ImageF halved(const ImageF& image);

/// Bilinear enlargement by `factor`, the inverse of repeated `halved`, to the given size.
ImageF enlarged(const ImageF& image, int factor, int width, int height);

/// Bilinear sample at (x, y) px; outside, the nearest edge value. The image must not be empty.
float sampled(const ImageF& image, double x, double y);

}   // namespace angiopose::core