#pragma once

#include "core/geometry/projection_camera.h"
#include "core/geometry/rigid_transform.h"
#include "core/vessel/vessel_tree.h"

#include <vector>

namespace angiopose::core {

/// Fisher information of a traced piece of vessel about steps (rotation rad, shift mm) about `centerInCamera` in camera
/// axes: one point per px that tells its distance across the vessel only, noise 1 px (ALGORITHMS §6.10). Zero where the
/// piece does not project.
Matrix6d pieceInformation(const ProjectionCamera& camera, const Eigen::Vector3d& fromInCamera,
                          const Eigen::Vector3d& toInCamera, const Eigen::Vector3d& centerInCamera);

/// What the image can learn from one branch at a pose.
struct BranchInformation {
    int branchId = 0;
    double lengthPx = 0.0;   ///< of its projection inside the image
    Matrix6d information = Matrix6d::Zero();   ///< order as PoseUncertainty, about the tree's centroid
};

/// Per branch, in the tree's order: what its projection inside the image tells about the pose, where neighbouring
/// traced points share their noise over about 10 px and it is 1 px wide.
std::vector<BranchInformation> branchInformation(const VesselTree& tree, const ProjectionCamera& camera,
                                                 const RigidTransform& cameraFromPatient);

/// 1-σ of the six steps when the branches in `ids` are seen and the start pose is known to `priorStd` (rad, mm).
Vector6d expectedStd(const std::vector<BranchInformation>& branches, const std::vector<int>& ids,
                     const Vector6d& priorStd);

/// Up to `count` branches, best first, each chosen to narrow one step (0…5) the most beside those before it; ends
/// early when another branch would narrow it by less than a twentieth.
std::vector<int> branchesThatPin(const std::vector<BranchInformation>& branches, int step, const Vector6d& priorStd,
                                 int count);

/// The fewest branches, best first, that leave every σ within `tolerance` (≥ 1) times that of all branches: greedy
/// D-optimal design (largest determinant of the information at each choice).
std::vector<int> bestInformedBranches(const std::vector<BranchInformation>& branches, const Vector6d& priorStd,
                                      double tolerance = 1.3);

}   // namespace angiopose::core