#pragma once

#include "core/registration/problem/registration_result.h"
#include "tests/benchmark/foreign/scene.h"
#include "tests/benchmark/foreign/trees.h"

#include <array>

namespace angiopose::benchmarks {

/// One registration problem and its answer.
struct ForeignCase {
    core::RegistrationInput input;
    core::RigidTransform truth;   ///< cameraFromPatient
    std::vector<std::size_t> filled;   ///< indices of the branches that the image shows; empty if it shows another tree
    std::size_t foreignCurves = 0;   ///< number of vessels that belong to no tree, the last curves of the target
};

/// Makes case number `trial` of a scene, the same on every call: the number determines pose, opacification, noise and
/// initial pose. Initial poses are off by up to 15°, 30 mm laterally and 50 mm in depth. For one wide vessel the tree
/// is modified, see foreign/wide_vessel.h.
ForeignCase makeForeignCase(const std::vector<RootedTree>& trees, std::size_t tree, ForeignScene scene,
                            std::uint64_t trial);

/// Makes two views of the whole tree 60° apart, as two problems. Their initial poses define the geometry between the
/// views, off by 0.25° and 0.75 mm (1-σ per axis) from the true one.
std::array<ForeignCase, 2> makeForeignPair(const std::vector<RootedTree>& trees, std::size_t tree, std::uint64_t trial);

struct ForeignError {
    double inPlaneMm = 0.0;   ///< mean over the opacified branches, perpendicular to the rays
    double spaceMm = 0.0;   ///< mean distance in 3-D
    double turnDeg = 0.0;
};
ForeignError errorOf(const ForeignCase& asked, const core::RigidTransform& answer);

}   // namespace angiopose::benchmarks
