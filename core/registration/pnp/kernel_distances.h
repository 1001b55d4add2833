#pragma once

#include "core/geometry/projection_camera.h"
#include "core/registration/matching/neighbor_search.h"
#include "core/registration/matching/point_index.h"
#include "core/registration/options/registration_options.h"
#include "core/registration/pnp/source_freedom.h"

#include <span>
#include <vector>

namespace angiopose::core {

/// Tree points, the camera, and the target to which the points are matched.
struct KernelProblem {
    std::span<const Eigen::Vector3d> points;   ///< mm, in the frame that the pose maps to the camera
    ProjectionCamera camera;
    const PointIndex* target = nullptr;   ///< index for matching to the nearest target point at every evaluation
    std::span<const Eigen::Vector2d>
        fixedMatchesPx;   ///< if not empty, one fixed match per point, independent of the pose
    const NeighborSearch* search = nullptr;   ///< for further matches by rule `neighbors`; unused with fixed matches
    Neighbors neighbors = Neighbors::Closest;
    SourceFreedom freedom{};   ///< allowed motions of the pose
};

/// Additional target point, besides the nearest, that attracts a tree point.
struct FurtherMatch {
    std::size_t point = 0;
    Eigen::Vector2d residualPx;   ///< projection minus target point
    double squaredPx = 0.0;
};

/// Distances of the points at one pose; the buffers are reused, so measuring does not allocate after the first call.
struct KernelDistances {
    std::vector<Eigen::Vector3d> inCamera;
    std::vector<Eigen::Vector2d> residualPx;   ///< projection minus matched target point
    std::vector<double> squaredPx;   ///< infinite for points that do not project
    std::vector<FurtherMatch> otherMatches;   ///< empty if only the nearest target points count
};

/// Projects all points, matches them (point to point) and measures the distances. The matches within a radius depend on
/// the kernel width.
void measureDistances(const KernelProblem& problem, const RigidTransform& pose, KernelDistances& distances,
                      double scalePx = 0.0);

/// Returns N − E_data (ALGORITHMS §1), which is Σ (1 − exp(−d²/2ℓ²)) if only the nearest matches count; accurate even
/// if all distances are tiny. A point that does not project costs the maximum, 1.
double kernelLoss(const KernelDistances& distances, double scalePx);

/// Returns the Gauss–Newton system of Σ exp(−d²/2ℓ²)‖r‖² for pose ← exp(ξ) pose, weights frozen (§3.1, step 2).
NormalEquations kernelEquations(const KernelProblem& problem, const KernelDistances& distances, double scalePx);

/// Returns the Gauss–Newton system of Huber's loss of the nearest distances, with the weights frozen.
NormalEquations huberEquations(const KernelProblem& problem, const KernelDistances& distances, double huberPx);

/// Returns the Huber loss: Σ d² up to `huberPx`, linear beyond. A point that does not project costs as much as a
/// distance of half the image.
double huberLoss(const KernelProblem& problem, const KernelDistances& distances, double huberPx);

/// Returns the largest distance of the points that project, px.
double maxDistancePx(const KernelDistances& distances);

/// Returns the number of pairs that are at most `radiusPx` apart.
int countWithin(const KernelDistances& distances, double radiusPx);

/// Returns the median distance, px; infinite if most points do not project.
double medianDistancePx(const KernelDistances& distances, std::vector<double>& scratch);

}   // namespace angiopose::core
