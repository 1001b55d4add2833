#pragma once

#include "core/imaging/image2d.h"

namespace angiopose::core {

/// Returns a one-pixel-wide skeleton (0/255) with the same 8-connected components and holes as the mask. Peels border
/// pixels from north, south, west and east in turn if they are simple (Yokoi's crossing number) and not a line end.
Mask2d skeletonize(const Mask2d& mask);

}   // namespace angiopose::core
