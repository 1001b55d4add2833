#pragma once

#include "tests/benchmark/asked_case.h"
#include "tests/benchmark/foreign/trees.h"

#include <cstdint>

namespace angiopose::benchmarks {

/// Trees of patients: cerebral arteries whole and by where blood flows in, coronaries of a CT, and those of a phantom;
/// what has fewer than eight branches is left out. Empty where the data are not there.
std::vector<RootedTree> judgingTrees(const std::string& dataFolder);

/// How many kinds of cases there are: filled in parts, bent, told wrongly, impossible.
std::size_t judgingKindCount();

/// The same on every call. By generators that no threshold was chosen with here (foreign/targets, bent_cases,
/// wrong_geometry).
AskedCase judgingCase(const std::vector<RootedTree>& trees, std::size_t tree, std::size_t kind, std::uint64_t trial);

}   // namespace angiopose::benchmarks
