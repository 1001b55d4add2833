#pragma once

#include <cstdint>

namespace angiopose::benchmarks {

/// Calls of `operator new` by this thread so far; the program that links this counts them.
std::uint64_t allocationsOfThisThread();

}   // namespace angiopose::benchmarks