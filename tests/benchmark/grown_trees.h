#pragma once

#include "core/vessel/vessel_tree.h"
#include "tests/benchmark/foreign/trees.h"

namespace angiopose::benchmarks {

/// A tree grown step by step from one to three roots: headings wander, branches divide into two or three, lengths and
/// angles are drawn for every tree. 7 to about 130 branches, 60 to 180 mm wide.
RootedTree grownTree(std::uint64_t number);

/// The tree after a random motion, with the same points: no motion, waves of any length, or one subtree rotated about
/// its origin; up to 8 mm.
core::VesselTree movedTree(const RootedTree& tree, ForeignRandom& random);

}   // namespace angiopose::benchmarks
