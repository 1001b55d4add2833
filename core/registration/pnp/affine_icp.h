#pragma once

#include "core/registration/pnp/point_solver.h"

namespace angiopose::core {

struct AffineOptions {
    double huberPx = 5.0;
    int maxIterations = 100;
};

/// Iterated closest points with an affine map of the camera frame that leaves depths alone (8 numbers, linear least
/// squares), from `start`; then the rigid pose that projects the points nearest to where the map takes them
/// (ALGORITHMS §3.6, option `affine`). The observer sees `start`: until the end there is no better rigid pose.
KernelPnpResult rigidPartOfAffineIcp(const KernelProblem& problem, const RigidTransform& start,
                                     const AffineOptions& options, const KernelObserver& observe);

}   // namespace angiopose::core