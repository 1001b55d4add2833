#pragma once

#include "core/geometry/projection_camera.h"
#include "core/registration/matching/neighbor_search.h"
#include "core/registration/matching/point_index.h"
#include "core/registration/options/registration_options.h"
#include "core/registration/pnp/source_freedom.h"

#include <span>
#include <vector>

namespace angiopose::core {

/// Tree points, their camera, and the data they are matched to.
struct KernelProblem {
    std::span<const Eigen::Vector3d> points;   ///< mm, in the frame from which the pose maps
    ProjectionCamera camera;
    const PointIndex* target = nullptr;   ///< every evaluation matches again to the nearest target point
    std::span<const Eigen::Vector2d>
        fixedPartnersPx;   ///< if not empty: one fixed partner per point, independent of the pose
    const NeighborSearch* search = nullptr;   ///< for further partners by the rule below; unused with fixed partners
    Neighbors neighbors = Neighbors::Closest;
    SourceFreedom freedom{};   ///< allowed motions of the pose
};

/// Partner in addition to the nearest.
struct FurtherPartner {
    std::size_t point = 0;
    Eigen::Vector2d residualPx;   ///< projection minus partner
    double squaredPx = 0.0;
};

/// Distances of the points at one pose. Buffers are reused: measuring does not allocate after the first call.
struct KernelDistances {
    std::vector<Eigen::Vector3d> inCamera;
    std::vector<Eigen::Vector2d> residualPx;   ///< projection minus partner
    std::vector<double> squaredPx;   ///< infinite for points that do not project
    std::vector<FurtherPartner> further;   ///< empty if only the nearest partners count
};

/// Projects, matches (point to point) and measures all points. The partners within a radius depend on the kernel width.
void measure(const KernelProblem& problem, const RigidTransform& pose, KernelDistances& distances,
             double scalePx = 0.0);

/// N − E_data, Σ (1 − exp(−d²/2ℓ²)) with nearest partners only (ALGORITHMS §1); stays accurate when all distances are
/// tiny. A point that leaves the image costs the maximum, 1.
double kernelLoss(const KernelDistances& distances, double scalePx);

/// Gauss–Newton system of Σ exp(−d²/2ℓ²)‖r‖² for pose ← exp(ξ) pose, weights frozen (§3.1, step 2).
NormalEquations kernelEquations(const KernelProblem& problem, const KernelDistances& distances, double scalePx);

/// Gauss–Newton system of Huber's loss of the nearest distances, weights frozen.
NormalEquations huberEquations(const KernelProblem& problem, const KernelDistances& distances, double huberPx);

/// Σ d² up to `huberPx`, growing linearly from there. Points that do not project cost as much as a distance of half the
/// image.
double huberLoss(const KernelProblem& problem, const KernelDistances& distances, double huberPx);

/// Largest distance of a point that projects, px.
double largestDistancePx(const KernelDistances& distances);

/// Number of pairs within `radiusPx` of each other.
int countWithin(const KernelDistances& distances, double radiusPx);

/// Median distance, px; infinite when most points do not project.
double medianDistancePx(const KernelDistances& distances, std::vector<double>& scratch);

}   // namespace angiopose::core