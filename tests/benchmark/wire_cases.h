#pragma once

#include "core/registration/problem/registration_result.h"
#include "tests/benchmark/foreign/trees.h"

#include <cstdint>
#include <string>
#include <vector>

namespace angiopose::benchmarks {

/// A tree of which the image shows nothing but a wire inside it.
struct WireCase {
    std::string tree;
    core::RegistrationInput input;   ///< the start is the last full pose
    core::RigidTransform cameraFromPatient;   ///< in truth
    std::vector<int> branchIds;   ///< that the wire takes, in order
    std::vector<Eigen::Vector3d> axisInPatient;   ///< of the vessels where the wire runs, up to its tip
    double offAxisMm = 0.0;   ///< rms of the wire from it
};

/// The world to learn from: trees grown step by step, a wire that wanders in the lumen and is pulled straight bit by
/// bit.
WireCase madeUpWireCase(std::uint64_t number);

/// The world to judge by: trees of patients, a wire that swings about the axis in waves and is averaged along it.
WireCase judgingWireCase(const RootedTree& tree, std::uint64_t trial);

}   // namespace angiopose::benchmarks
