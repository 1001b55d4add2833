#pragma once

#include "core/geometry/projection_camera.h"
#include "core/geometry/rigid_transform.h"
#include "core/vessel/vessel_tree.h"

#include <vector>

namespace angiopose::core {

/// Returns the Fisher information of a straight vessel segment for pose steps (rotation rad, shift mm) about
/// `centerInCamera` in camera axes (ALGORITHMS §6.10), assuming one traced point per px with 1 px noise across the
/// vessel. Zero if the segment does not project.
Matrix6d segmentInformation(const ProjectionCamera& camera, const Eigen::Vector3d& fromInCamera,
                            const Eigen::Vector3d& toInCamera, const Eigen::Vector3d& centerInCamera);

/// Information that one branch contributes at a pose.
struct BranchInformation {
    int branchId = 0;
    double lengthPx = 0.0;   ///< projected length inside the image
    Matrix6d information = Matrix6d::Zero();   ///< same order as PoseUncertainty, about the tree's centroid
};

/// Returns the information about the pose from the projection of each branch inside the image, in the tree's order; the
/// noise of traced points is assumed to be 1 px, correlated over about 10 px.
std::vector<BranchInformation> branchInformation(const VesselTree& tree, const ProjectionCamera& camera,
                                                 const RigidTransform& cameraFromPatient);

/// Returns the expected 1-σ of the six step components if the branches in `ids` are visible and the initial pose has
/// the 1-σ errors `priorStd` (rad, mm).
Vector6d expectedStd(const std::vector<BranchInformation>& branches, const std::vector<int>& ids,
                     const Vector6d& priorStd);

/// Returns up to `count` branches, best first: each is the one that, given the previous ones, most reduces the σ of one
/// step component (0…5). Stops early if another branch would reduce σ by less than a twentieth.
std::vector<int> bestBranchesForComponent(const std::vector<BranchInformation>& branches, int step,
                                          const Vector6d& priorStd, int count);

/// Returns a small set of branches, best first, that keeps every σ within `tolerance` (≥ 1) times its value for all
/// branches: greedy D-optimal design, which picks the largest determinant of the information each time.
std::vector<int> informativeBranchSet(const std::vector<BranchInformation>& branches, const Vector6d& priorStd,
                                      double tolerance = 1.3);

}   // namespace angiopose::core
