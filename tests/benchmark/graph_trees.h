#pragma once

#include "core/support/random.h"
#include "core/vessel/vessel_tree.h"
#include "tests/benchmark/artery_graph.h"

#include <cstdint>
#include <string>

namespace angiopose::benchmarks {

/// Number of real cerebral trees, given as bifurcations and endpoints of traced arteries with the lengths between them.
inline constexpr int graphTreeCount = arteryGraphCount;

/// The tree of a graph (0…4), about 130 mm across, patient axes with the origin at its center: every edge is a smooth
/// curve of about its true length (a different curve for each seed), points 1 mm apart. Empty if the data are missing.
core::VesselTree graphTree(int number, core::CounterRandom random);

/// Tree `number` for the tables of deformed vessels. "grown": simulated trees for choosing options; otherwise real
/// cerebral ones as the test set.
core::VesselTree treeToDeform(const std::string& which, std::uint64_t number);

}   // namespace angiopose::benchmarks
