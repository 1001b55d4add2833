#pragma once

#include "core/registration/deformable/deform_vessels.h"
#include "core/registration/deformable/deformation_fit.h"

#include <span>
#include <vector>

namespace angiopose::core {

using KnotPlaces = std::vector<Eigen::Vector3d>;

/// Of the knots as a run has them, in the camera of the first view.
KnotPlaces placesInCamera(const DeformationProblem& problem, const DeformationFit& fit);

/// How much each run counts, by how likely it is beside the best one; their sum is 1.
std::vector<double> sharesOfRuns(const std::vector<DeformationFit>& runs, std::size_t best);

/// What the covariances of a run are too small by, at least 1: what its field did not follow does not average out.
double inflationOf(const DeformationFit& fit);

/// What the best of several runs says, for every point of the tree: the nearest rigid pose, what is left as motion, and
/// a covariance that holds the spread between the runs too (ALGORITHMS §11.4).
DeformableResult deformedResult(std::span<const DeformableView> views, const DeformationProblem& problem,
                                const std::vector<DeformationFit>& runs, std::size_t best);

/// The rigid poses as they are, without motion.
DeformableResult rigidResult(std::span<const DeformableView> views);

/// The rigid motion that lays `from` onto `to` with the least weighted squares (Kabsch 1976).
RigidTransform nearestRigid(const std::vector<Eigen::Vector3d>& from, const std::vector<Eigen::Vector3d>& to,
                            const std::vector<double>& weights);

}   // namespace angiopose::core
