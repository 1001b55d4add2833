#pragma once

#include "tests/benchmark/foreign/scene.h"
#include "tests/benchmark/foreign/trees.h"

#include <cstddef>
#include <vector>

namespace angiopose::benchmarks {

std::vector<std::size_t> allOf(const RootedTree& tree);

/// Indices of the opacified branches in a scene, drawn at random where the scene leaves a choice.
std::vector<std::size_t> filledIn(const RootedTree& tree, ForeignScene scene, ForeignRandom& random);

}   // namespace angiopose::benchmarks
