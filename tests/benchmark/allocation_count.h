#pragma once

#include <cstdint>

namespace angiopose::benchmarks {

/// Number of calls of `operator new` by this thread so far. Linking this file into a program enables the counting.
std::uint64_t allocationsOfThisThread();

}   // namespace angiopose::benchmarks
