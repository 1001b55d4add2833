#pragma once

#include "core/imaging/image2d.h"
#include "core/support/random.h"

namespace angiopose::core {

/// What lies around the vessels, as −ln of its transmission relative to the average patient: soft tissue, bones with
/// their bright rims, spongy texture, now and then a monitoring lead.
ImageF bodyAttenuation(int width, int height, CounterRandom& random);

}   // namespace angiopose::core