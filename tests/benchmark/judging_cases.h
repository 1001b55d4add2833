#pragma once

#include "tests/benchmark/asked_case.h"
#include "tests/benchmark/foreign/trees.h"

#include <cstdint>

namespace angiopose::benchmarks {

/// Trees of patients: whole cerebral arteries and their parts by inflow, coronary arteries from a CT, and those of a
/// phantom. Omits trees with fewer than eight branches. Empty if the data are missing.
std::vector<RootedTree> judgingTrees(const std::string& dataFolder);

/// Number of kinds of cases: partly opacified, deformed, with wrong geometry, impossible.
std::size_t judgingKindCount();

/// Makes a case, the same on every call, with generators that were not used to choose thresholds here (foreign/targets,
/// deformed_cases, wrong_geometry).
RequestedCase judgingCase(const std::vector<RootedTree>& trees, std::size_t tree, std::size_t kind,
                          std::uint64_t trial);

}   // namespace angiopose::benchmarks
