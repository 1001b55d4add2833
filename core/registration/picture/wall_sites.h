#pragma once

#include "core/imaging/image2d.h"
#include "core/registration/pose/centroid_pose.h"
#include "core/registration/problem/registration_problem.h"

namespace angiopose::core {

/// A place on a vessel's wall, where a CT has its gradient along the normal.
struct WallSite {
    Eigen::Vector3d place;   ///< mm from the tree's centroid, patient axes
    Eigen::Vector3d normal;   ///< unit, outwards
};

/// At most `most` places all around the vessels, evenly spread.
std::vector<WallSite> wallSites(const TreeSamples& tree, std::size_t most);

/// Agreement of walls with the gradients of the image carried back along the rays (Markelj 2008).
class BackprojectedGradients {
public:
    BackprojectedGradients(const ImageF& picture, const ProjectionCamera& camera, double blurPx);

    /// |v_B| f(β) at a place in the camera frame (mm) for a wall with this normal; 0 outside the image.
    double agreement(const Eigen::Vector3d& place, const Eigen::Vector3d& normal) const;

    /// Mean agreement of all sites under a pose.
    double score(const std::vector<WallSite>& sites, const CentroidPose& pose) const;

    const ProjectionCamera& camera() const { return camera_; }

private:
    ImageF picture_;
    ProjectionCamera camera_;
};

}   // namespace angiopose::core