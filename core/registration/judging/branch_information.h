#pragma once

#include "core/geometry/projection_camera.h"
#include "core/geometry/rigid_transform.h"
#include "core/vessel/vessel_tree.h"

#include <vector>

namespace angiopose::core {

/// Fisher information of a traced vessel piece about steps (rotation rad, shift mm) about `centerInCamera` in camera
/// axes: one point per px, each measuring only its distance across the vessel, noise 1 px (ALGORITHMS §6.10). Zero if
/// the piece does not project.
Matrix6d pieceInformation(const ProjectionCamera& camera, const Eigen::Vector3d& fromInCamera,
                          const Eigen::Vector3d& toInCamera, const Eigen::Vector3d& centerInCamera);

/// Information that one branch contributes at a pose.
struct BranchInformation {
    int branchId = 0;
    double lengthPx = 0.0;   ///< length of its projection inside the image
    Matrix6d information = Matrix6d::Zero();   ///< same order as PoseUncertainty, about the tree's centroid
};

/// Information about the pose per branch, in the tree's order, from its projection inside the image; the noise of
/// traced points is 1 px and correlated over about 10 px.
std::vector<BranchInformation> branchInformation(const VesselTree& tree, const ProjectionCamera& camera,
                                                 const RigidTransform& cameraFromPatient);

/// Expected 1-σ of the six steps when the branches in `ids` are visible and the initial pose is known to `priorStd`
/// (rad, mm).
Vector6d expectedStd(const std::vector<BranchInformation>& branches, const std::vector<int>& ids,
                     const Vector6d& priorStd);

/// Up to `count` branches, best first, each selected to narrow one step (0…5) most in addition to the previous ones;
/// ends early when another branch would narrow it by less than a twentieth.
std::vector<int> branchesThatPin(const std::vector<BranchInformation>& branches, int step, const Vector6d& priorStd,
                                 int count);

/// Smallest set of branches, best first, that keeps every σ within `tolerance` (≥ 1) times that of all branches: greedy
/// D-optimal design (largest determinant of the information at each selection).
std::vector<int> bestInformedBranches(const std::vector<BranchInformation>& branches, const Vector6d& priorStd,
                                      double tolerance = 1.3);

}   // namespace angiopose::core