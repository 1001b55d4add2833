#pragma once

#include "core/registration/problem/registration_result.h"
#include "tests/benchmark/foreign/scene.h"
#include "tests/benchmark/foreign/trees.h"

#include <cstddef>
#include <vector>

namespace angiopose::benchmarks {

using Pixels = std::vector<Eigen::Vector2d>;

/// A polyline as a tracer leaves it: off by what neighbours share, rounded to pixels, cut at the image's edges.
Pixels traced(const Pixels& curve, ForeignRandom& random);

/// A vessel that the tree does not have, as it runs.
Pixels foreignCurve(ForeignRandom& random);

/// The filled branches of a tree as traced in a view, a curve each.
std::vector<Pixels> seen(const RootedTree& shown, const std::vector<std::size_t>& filled,
                         const core::RigidTransform& cameraFromPatient, ForeignRandom& random);

/// Short wriggling curves, or points one by one.
std::vector<Pixels> noVessels(ForeignScene scene, ForeignRandom& random);

/// The curves in the order and form that a scene asks for; empty ones are left out.
core::Centerline2d handedOver(std::vector<Pixels> curves, ForeignScene scene, ForeignRandom& random);

}   // namespace angiopose::benchmarks
