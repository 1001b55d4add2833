#pragma once

#include "tests/benchmark/foreign/targets.h"

namespace angiopose::benchmarks {

/// Result of the default method for a case.
struct ForeignAnswer {
    ForeignError error;
    bool isTrusted = false;
    double timeMs = 0.0;
};

/// Registers by the default method. A failure is reported on stderr and counts as far off and unreliable.
ForeignAnswer ask(const ForeignCase& asked);

}   // namespace angiopose::benchmarks
