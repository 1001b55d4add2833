#pragma once

#include "core/support/random.h"
#include "core/vessel/vessel_tree.h"
#include "tests/benchmark/artery_graph.h"

#include <cstdint>
#include <string>

namespace angiopose::benchmarks {

/// How many real cerebral trees there are: bifurcations and ends of traced arteries with the lengths between them.
inline constexpr int graphTreeCount = arteryGraphCount;

/// The tree of a graph (0…4), about 130 mm across, patient axes about the origin: every edge a smooth curve of about
/// its true length (bent anew for each seed), points 1 mm apart. Empty without the data.
core::VesselTree graphTree(int number, core::CounterRandom random);

/// Number `number` of the trees that are bent in tables. "grown": simulated ones, to choose options on; else real
/// cerebral ones, to judge.
core::VesselTree treeToDeform(const std::string& which, std::uint64_t number);

}   // namespace angiopose::benchmarks
