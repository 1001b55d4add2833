#pragma once

#include "core/registration/deformable/deform_vessels.h"
#include "core/registration/deformable/deformation_fit.h"

#include <span>
#include <vector>

namespace angiopose::core {

using KnotPositions = std::vector<Eigen::Vector3d>;

/// Returns the knot positions of a fit in the camera of the first view.
KnotPositions knotPositionsInCamera(const DeformationProblem& problem, const DeformationFit& fit);

/// Returns the weight of each fit from its likelihood relative to the best one; the weights sum to 1.
std::vector<double> fitWeights(const std::vector<DeformationFit>& fits, std::size_t best);

/// Returns the factor, at least 1, by which to scale up the covariances of a fit to account for motion that the field
/// does not capture and that does not average out.
double covarianceInflation(const DeformationFit& fit);

/// Builds the result of the best of several fits: the nearest rigid pose, the remaining motion of every tree point, and
/// a covariance that includes the spread between the fits (ALGORITHMS §11.4).
DeformableResult deformedResult(std::span<const DeformableView> views, const DeformationProblem& problem,
                                const std::vector<DeformationFit>& fits, std::size_t best);

/// Returns a result without motion, with the rigid poses unchanged.
DeformableResult rigidResult(std::span<const DeformableView> views);

/// Returns the rigid motion that maps `from` onto `to` with the smallest weighted sum of squares (Kabsch 1976).
RigidTransform fitRigidTransform(const std::vector<Eigen::Vector3d>& from, const std::vector<Eigen::Vector3d>& to,
                                 const std::vector<double>& weights);

}   // namespace angiopose::core
