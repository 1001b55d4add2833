#pragma once

#include "core/registration/deformable/deform_vessels.h"

#include <cstddef>
#include <vector>

namespace angiopose::core {

/// Whether a result belongs to this tree: same branches, each with the same number of points, in any order.
bool isCompatible(const VesselTree& tree, const DeformableResult& result);

/// Whether the result contains nonrigid motion; false if the fit was stopped before it reached a verdict.
bool isDeformed(const DeformableResult& result);

const BranchMotion* findMotion(const DeformableResult& result, int branchId);   ///< null if there is none

/// Returns the tree with the displacements of a result applied, patient LPS; an empty tree if the result does not
/// belong to this tree.
VesselTree deformedTree(const VesselTree& tree, const DeformableResult& result);

/// Returns the deformed tree in the patient axes of another pose of the first view: projected with `cameraFromPatient`,
/// usually the rigid pose, it coincides with the deformed vessels.
VesselTree deformedTreeAt(const VesselTree& tree, const DeformableResult& result,
                          const RigidTransform& cameraFromPatient);

/// Returns the distance of each point of a branch from the same point in the other tree, mm, with both trees in the
/// camera of `cameraFromPatient`: across the ray for a single view, otherwise in 3-D.
std::vector<double> pointDistances(const VesselBranch& branch, const VesselBranch& other,
                                   const RigidTransform& cameraFromPatient, std::size_t viewCount);

/// Returns the same result with the given view moved to the first place.
DeformableResult withViewFirst(DeformableResult result, std::size_t view);

/// Rounds to the precision of files, which is as fine as the known accuracy: motions to 1 µm, covariances to three
/// digits.
void roundMotion(BranchMotion& motion);

}   // namespace angiopose::core
