#pragma once

#include "tests/benchmark/asked_case.h"

#include <cstdint>

namespace angiopose::benchmarks {

/// Makes case `number` of an artificial training set, the same on every call: trees grown step by step; sizes, views,
/// opacification, motion, noise, gaps, foreign vessels, catheters, wrong geometry and initial poses drawn at random
/// over wide ranges. Shares no code with the generators of the test set (foreign/targets, deformed_cases) or with the
/// program's simulator. Every four consecutive numbers share one tree.
RequestedCase mixedCase(std::uint64_t number);

}   // namespace angiopose::benchmarks
