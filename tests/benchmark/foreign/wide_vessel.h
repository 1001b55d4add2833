#pragma once

#include "tests/benchmark/foreign/trees.h"

#include <cstddef>
#include <vector>

namespace angiopose::benchmarks {

/// A tree as a carotid of 5 mm with the fine branches about it.
struct WideVesselTree {
    RootedTree tree;   ///< wide along `wide`, all other branches of it fine
    std::vector<std::size_t> wide;   ///< indices of the branches of the one wide vessel, from where blood flows in
    std::vector<std::size_t> beside;   ///< of the fine branches that leave it
};

/// The widest vessel of a tree from an inflow on, of 6 to 12 cm as far as the tree has it, made 5 mm wide where it
/// begins and 4 mm where it ends; what is left of the tree becomes fine, 0.8 to 1.6 mm, and keeps its order.
WideVesselTree withWideVessel(const RootedTree& tree);

}   // namespace angiopose::benchmarks
