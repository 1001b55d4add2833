#pragma once

#include "tests/benchmark/phantom_views.h"

namespace angiopose::benchmarks {

/// The rotations of views registered from where they stand, and the mean of their median distances; none where one
/// fails.
std::vector<Eigen::Matrix3d> rotationsOf(const std::vector<core::RegistrationInput>& inputs, double& medianPx);

/// Prints how well the relative rotations can be expected to agree when the tree is off the vessel's shape by a smooth
/// random error and the header's angles are off what the gantry did. The simulated views show the parts that the real
/// ones show, at the poses found there.
void printFloor(const std::vector<PhantomView>& views, int trials, std::uint64_t seed);

}   // namespace angiopose::benchmarks