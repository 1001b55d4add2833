#pragma once

#include "core/registration/pnp/point_solver.h"

namespace angiopose::core {

struct AffineOptions {
    double huberPx = 5.0;
    int maxIterations = 100;
};

/// Runs iterative closest point from `start` with an affine map of the camera frame that keeps depths unchanged (8
/// parameters, linear least squares), then finds the rigid pose whose projection is closest to the mapped points
/// (ALGORITHMS §3.6, option `icpModel`). The observer receives `start`, as there is no better rigid pose until the end.
KernelPnpResult rigidPartOfAffineIcp(const KernelProblem& problem, const RigidTransform& start,
                                     const AffineOptions& options, const KernelObserver& observe);

}   // namespace angiopose::core
