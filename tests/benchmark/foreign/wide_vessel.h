#pragma once

#include "tests/benchmark/foreign/trees.h"

#include <cstddef>
#include <vector>

namespace angiopose::benchmarks {

/// A tree turned into a carotid of 5 mm with thin branches around it.
struct WideVesselTree {
    RootedTree tree;   ///< wide along `wide`, thin in all other branches
    std::vector<std::size_t> wide;   ///< indices of the branches of the wide vessel, from the inflow
    std::vector<std::size_t> beside;   ///< indices of the thin branches that leave it
};

/// Takes the widest vessel of a tree from an inflow, 6 to 12 cm long if the tree allows, and makes it 5 mm wide at its
/// origin and 4 mm at its end. The rest of the tree becomes thin, 0.8 to 1.6 mm, and keeps its order.
WideVesselTree withWideVessel(const RootedTree& tree);

}   // namespace angiopose::benchmarks
