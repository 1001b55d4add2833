#pragma once

#include "core/imaging/image2d.h"

namespace angiopose::core {

/// `blurred` for any σ in nearly constant time: above σ = 8 px it works on a reduced image.
ImageF widelyBlurred(const ImageF& image, double sigmaPx);

}   // namespace angiopose::core