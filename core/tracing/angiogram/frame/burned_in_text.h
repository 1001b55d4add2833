#pragma once

#include "core/imaging/image2d.h"

namespace angiopose::core {

/// Maximum letter height, as a fraction of the image's longer side: for tracing, and for searches that must miss no
/// name.
inline constexpr double defaultMaxLetterHeight = 0.06;
inline constexpr double thoroughMaxLetterHeight = 0.15;

/// Returns a mask (255 on the text, 0 elsewhere) of letters and digits burned into the image, with a small margin: rows
/// of three or more small shapes of similar height with hard edges, which have the image's minimum or maximum value or
/// one exact value in between. X-ray images contain neither hard edges nor rows of equal shapes.
Mask2d burnedInTextMask(const ImageF& frame, double maxLetterHeight = defaultMaxLetterHeight);

}   // namespace angiopose::core
