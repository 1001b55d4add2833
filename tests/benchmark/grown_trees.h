#pragma once

#include "core/vessel/vessel_tree.h"
#include "tests/benchmark/foreign/trees.h"

namespace angiopose::benchmarks {

/// A tree grown step by step from one to three roots: headings wander, branches part into two or three, lengths and
/// angles are drawn anew for every tree. 7 to about 130 branches, 60 to 180 mm wide.
RootedTree grownTree(std::uint64_t number);

/// The tree after a motion drawn at random, the same points: none, waves of every length, or one subtree turned about
/// where it begins; up to 8 mm.
core::VesselTree movedTree(const RootedTree& tree, ForeignRandom& random);

}   // namespace angiopose::benchmarks
