#pragma once

#include "core/imaging/image2d.h"

namespace angiopose::core {

/// Maximum letter height searched for, as a share of the image's longer side: for traced images, and where a name must
/// not be missed.
inline constexpr double usualLetterShare = 0.06;
inline constexpr double informativeLetterShare = 0.15;

/// 255 where letters and digits were drawn into the image, with a small margin, 0 elsewhere: small shapes of the
/// image's minimum or maximum value, or of one exact value between them, with hard edges, three or more of similar
/// height in a row. X-ray images contain neither hard edges nor rows of equal shapes.
Mask2d burnedInText(const ImageF& frame, double greatestHeightShare = usualLetterShare);

}   // namespace angiopose::core