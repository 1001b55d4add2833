#pragma once

#include "core/imaging/image2d.h"

namespace angiopose::core {

/// How high letters are looked for, of the picture's longer side: in images that are traced, and where a name must not
/// be missed.
inline constexpr double usualLetterShare = 0.06;
inline constexpr double informativeLetterShare = 0.15;

/// 255 where letters and numbers were drawn into the picture, with a little margin, 0 elsewhere: small shapes of the
/// picture's least or greatest value, or of one exact value between them, with hard edges, three or more of about one
/// height in a row. X-rays give neither hard edges nor rows of equal shapes.
Mask2d burnedInText(const ImageF& frame, double greatestHeightShare = usualLetterShare);

}   // namespace angiopose::core