#pragma once

#include "core/registration/deformable/deform_vessels.h"

#include <cstddef>
#include <vector>

namespace angiopose::core {

/// Whether a result is one of this tree: the same branches with as many points each, in any order.
bool isOf(const VesselTree& tree, const DeformableResult& result);

/// Whether it found vessels that are no rigid body, and was not stopped before that was known.
bool isDeformed(const DeformableResult& result);

const BranchMotion* motionOf(const DeformableResult& result, int branchId);   ///< null: none

/// The tree with the displacements of a result, patient LPS. Nothing where the result is not of this tree.
VesselTree deformedTree(const VesselTree& tree, const DeformableResult& result);

/// The bent tree in the patient axes of another pose of the first view: projected with `cameraFromPatient`, mostly the
/// rigid pose, it lies where the bent vessels lie.
VesselTree deformedTreeAt(const VesselTree& tree, const DeformableResult& result,
                          const RigidTransform& cameraFromPatient);

/// How far each point of a branch lies from its place in the other tree, mm, both projected with `cameraFromPatient`:
/// across the ray where one view tells, else in space.
std::vector<double> distancesApart(const VesselBranch& branch, const VesselBranch& other,
                                   const RigidTransform& cameraFromPatient, std::size_t viewCount);

/// The same result with another of its views as the first.
DeformableResult seenFirst(DeformableResult result, std::size_t view);

/// As exact as it is known and as a file says it: motions to 1 µm, covariances to three digits.
void roundMotion(BranchMotion& motion);

}   // namespace angiopose::core
