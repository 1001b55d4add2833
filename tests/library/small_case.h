#pragma once

#include "angiopose/angiopose.h"

namespace angiopose::test {

/// A simulated case that is quick to register and identical at every call.
inline SimulatedCase smallCase()
{
    SimulationOptions options;
    options.branchCount = 8;
    options.frameCount = 3;
    return simulateCase(5, options);
}

}   // namespace angiopose::test
