#pragma once

#include "core/registration/problem/registration_result.h"
#include "tests/benchmark/foreign/trees.h"

#include <cstdint>
#include <string>
#include <vector>

namespace angiopose::benchmarks {

/// A tree in whose image only a guidewire inside the tree is visible.
struct WireCase {
    std::string tree;
    core::RegistrationInput input;   ///< the initial pose is the last pose of opacified vessels
    core::RigidTransform cameraFromPatient;   ///< true pose
    std::vector<int> branchIds;   ///< branches that contain the guidewire, in order
    std::vector<Eigen::Vector3d> axisInPatient;   ///< vessel axis along the guidewire, up to its tip
    double offAxisMm = 0.0;   ///< rms distance of the guidewire from the axis
};

/// A training case: trees grown step by step, with a guidewire that wanders in the lumen and is straightened step by
/// step.
WireCase madeUpWireCase(std::uint64_t number);

/// A test case: trees of patients, with a guidewire that swings about the axis in waves and is averaged along it.
WireCase judgingWireCase(const RootedTree& tree, std::uint64_t trial);

}   // namespace angiopose::benchmarks
