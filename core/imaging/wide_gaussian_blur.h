#pragma once

#include "core/imaging/image2d.h"

namespace angiopose::core {

/// Returns the same as gaussianBlur in nearly constant time for any σ, by working on a reduced image above σ = 8 px.
ImageF wideGaussianBlur(const ImageF& image, double sigmaPx);

}   // namespace angiopose::core
