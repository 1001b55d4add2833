#pragma once

#include "core/registration/problem/registration_result.h"
#include "tests/benchmark/foreign/scene.h"
#include "tests/benchmark/foreign/trees.h"

#include <array>

namespace angiopose::benchmarks {

/// One question to the solver and its answer.
struct ForeignCase {
    core::RegistrationInput input;
    core::RigidTransform truth;   ///< cameraFromPatient
    std::vector<std::size_t> filled;   ///< indices of the branches that the image shows; empty: another tree's
    std::size_t foreignCurves = 0;   ///< how many of the target's curves, the last ones, are vessels that no tree has
};

/// Numbers `trial` of a scene, the same on every call: pose, filling, noise and start follow from it. Starts are up to
/// 15°, 30 mm across and 50 mm along the ray off. For one wide vessel the tree is changed, see foreign/wide_vessel.h.
ForeignCase makeForeignCase(const std::vector<RootedTree>& trees, std::size_t tree, ForeignScene scene,
                            std::uint64_t trial);

/// The whole tree in two views 60° apart, as two questions whose start poses tell the geometry between them, off by
/// 0.25° and 0.75 mm (1-σ per axis) from the true one.
std::array<ForeignCase, 2> makeForeignPair(const std::vector<RootedTree>& trees, std::size_t tree, std::uint64_t trial);

/// How far an answer lies from the truth.
struct ForeignError {
    double inPlaneMm = 0.0;   ///< mean over the filled branches, across the rays
    double spaceMm = 0.0;   ///< mean distance in 3-D
    double turnDeg = 0.0;
};
ForeignError errorOf(const ForeignCase& asked, const core::RigidTransform& answer);

}   // namespace angiopose::benchmarks
