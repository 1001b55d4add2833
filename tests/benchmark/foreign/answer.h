#pragma once

#include "tests/benchmark/foreign/targets.h"

namespace angiopose::benchmarks {

/// What the default method says to a question.
struct ForeignAnswer {
    ForeignError error;
    bool isTrusted = false;
    double timeMs = 0.0;
};

/// One that fails says why on stderr, and counts as far off and not trusted.
ForeignAnswer ask(const ForeignCase& asked);

}   // namespace angiopose::benchmarks
