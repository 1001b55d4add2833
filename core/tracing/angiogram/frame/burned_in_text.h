#pragma once

#include "core/imaging/image2d.h"

namespace angiopose::core {

/// 255 where letters and numbers were drawn into the picture, with a little margin, 0 elsewhere: small shapes of the
/// picture's least or greatest value, or of one exact value between them, with hard edges, three or more of about one
/// height in a row. X-rays give neither hard edges nor rows of equal shapes.
Mask2d burnedInText(const ImageF& frame);

}   // namespace angiopose::core