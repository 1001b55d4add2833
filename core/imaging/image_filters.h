#pragma once

#include "core/imaging/image2d.h"

namespace angiopose::core {

/// Gaussian smoothing; edge pixels are replicated beyond the image. `sigmaPx` ≤ 0 returns the image unchanged. The
/// result does not depend on the number of threads.
ImageF blurred(const ImageF& image, double sigmaPx, int threads = 1);

/// Returns, for each pixel, the maximum in the surrounding square of side 2·`radiusPx` + 1, clipped to the image.
ImageF largestAround(const ImageF& image, int radiusPx);

/// Returns the means of 2×2 pixels: pixel (i, j) lies at (2i + 0.5, 2j + 0.5) of the source. Odd last rows and columns
/// are repeated.
ImageF halved(const ImageF& image);

/// Enlarges bilinearly by `factor` to the given size; inverse of repeated `halved`.
ImageF enlarged(const ImageF& image, int factor, int width, int height);

/// Returns the bilinear sample at (x, y) px; outside, the nearest edge value. The image must not be empty.
float sampled(const ImageF& image, double x, double y);

}   // namespace angiopose::core