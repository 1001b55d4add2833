#pragma once

#include "tests/benchmark/asked_case.h"

#include <cstdint>

namespace angiopose::benchmarks {

/// Number `number` of a world made up to learn from, the same on every call: trees grown step by step, sizes, views,
/// filling, motion, noise, gaps, foreign vessels, catheters, wrong geometry and starts drawn at random over wide
/// ranges. Shares no code with the generators that judge (foreign/targets, bent_cases), nor with the program's
/// simulator. Every fourth number has the same tree as its neighbours.
AskedCase mixedCase(std::uint64_t number);

}   // namespace angiopose::benchmarks
