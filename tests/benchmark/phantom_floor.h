#pragma once

#include "tests/benchmark/phantom_views.h"

namespace angiopose::benchmarks {

/// Rotations of the views registered from their poses, and the mean of their median distances; empty if one fails.
std::vector<Eigen::Matrix3d> rotationsOf(const std::vector<core::RegistrationInput>& inputs, double& medianPx);

/// Prints the agreement of the relative rotations to be expected when the tree differs from the vessel's shape by a
/// smooth random error and the header's angles differ from the gantry's. The simulated views show the same parts as the
/// real ones, at the poses found there.
void printFloor(const std::vector<PhantomView>& views, int trials, std::uint64_t seed);

}   // namespace angiopose::benchmarks
