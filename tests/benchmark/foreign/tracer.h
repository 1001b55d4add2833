#pragma once

#include "core/registration/problem/registration_result.h"
#include "tests/benchmark/foreign/scene.h"
#include "tests/benchmark/foreign/trees.h"

#include <cstddef>
#include <vector>

namespace angiopose::benchmarks {

using Pixels = std::vector<Eigen::Vector2d>;

/// A polyline as traced: with errors correlated between neighbors, rounded to pixels, cut at the image's edges.
Pixels traced(const Pixels& curve, ForeignRandom& random);

/// A random curve of a vessel that the tree does not have.
Pixels foreignCurve(ForeignRandom& random);

/// Traces the opacified branches of a tree in a view, one curve per branch.
std::vector<Pixels> seen(const RootedTree& shown, const std::vector<std::size_t>& filled,
                         const core::RigidTransform& cameraFromPatient, ForeignRandom& random);

/// Short wriggling curves or single points, depending on the scene.
std::vector<Pixels> noVessels(ForeignScene scene, ForeignRandom& random);

/// Puts the curves into the order and form that the scene requires; omits empty ones.
core::Centerline2d handedOver(std::vector<Pixels> curves, ForeignScene scene, ForeignRandom& random);

}   // namespace angiopose::benchmarks
