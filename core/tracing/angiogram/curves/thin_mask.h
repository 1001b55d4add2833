#pragma once

#include "core/imaging/image2d.h"

namespace angiopose::core {

/// One pixel wide skeleton (0/255) with the same 8-connected components and the same holes as the mask. Peels border
/// pixels from north, south, west and east in turn, each only while simple (Yokoi's crossing number) and no line end.
Mask2d thinned(const Mask2d& mask);

}   // namespace angiopose::core