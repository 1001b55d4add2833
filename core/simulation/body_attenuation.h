#pragma once

#include "core/imaging/image2d.h"
#include "core/support/random.h"

namespace angiopose::core {

/// Returns the background around the vessels, as −ln of its transmission relative to the average patient: soft tissue,
/// bones with bright rims, spongy texture, and sometimes a monitoring lead.
ImageF bodyAttenuation(int width, int height, CounterRandom& random);

}   // namespace angiopose::core