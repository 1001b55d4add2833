#pragma once

#include "core/registration/deformable/deform_vessels.h"
#include "core/registration/deformable/deformation_fit.h"

#include <span>
#include <vector>

namespace angiopose::core {

using KnotPlaces = std::vector<Eigen::Vector3d>;

/// Positions of the knots in a run, in the camera of the first view.
KnotPlaces placesInCamera(const DeformationProblem& problem, const DeformationFit& fit);

/// Weight of each run according to its likelihood relative to the best one; the weights sum to 1.
std::vector<double> sharesOfRuns(const std::vector<DeformationFit>& runs, std::size_t best);

/// Factor, at least 1, by which the covariances of a run must be scaled up: motion that its field did not capture does
/// not average out.
double inflationOf(const DeformationFit& fit);

/// Result of the best of several runs for every point of the tree: the nearest rigid pose, the remaining motion, and a
/// covariance that includes the spread between the runs (ALGORITHMS §11.4).
DeformableResult deformedResult(std::span<const DeformableView> views, const DeformationProblem& problem,
                                const std::vector<DeformationFit>& runs, std::size_t best);

/// Result with the unchanged rigid poses and no motion.
DeformableResult rigidResult(std::span<const DeformableView> views);

/// Rigid motion that maps `from` onto `to` with the smallest weighted sum of squares (Kabsch 1976).
RigidTransform nearestRigid(const std::vector<Eigen::Vector3d>& from, const std::vector<Eigen::Vector3d>& to,
                            const std::vector<double>& weights);

}   // namespace angiopose::core
