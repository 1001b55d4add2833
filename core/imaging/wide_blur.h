#pragma once

#include "core/imaging/image2d.h"

namespace angiopose::core {

/// Same as `blurred`, in nearly constant time for any σ: above σ = 8 px it works on a reduced image.
ImageF widelyBlurred(const ImageF& image, double sigmaPx);

}   // namespace angiopose::core