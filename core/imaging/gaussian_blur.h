#pragma once

#include "core/imaging/image2d.h"

namespace core {

/// The image blurred by a Gaussian; border pixels repeat outwards. Above σ = 4 px by three box filters (Wells 1986),
/// whose time does not depend on σ.
ImageF gaussianBlurred(const ImageF& image, double sigmaPx);

}   // namespace core
