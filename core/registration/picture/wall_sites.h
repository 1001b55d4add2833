#pragma once

#include "core/imaging/image2d.h"
#include "core/registration/pose/centroid_pose.h"
#include "core/registration/problem/registration_problem.h"

namespace angiopose::core {

/// Point on a vessel wall, where a CT has its gradient along the normal.
struct WallSite {
    Eigen::Vector3d place;   ///< mm relative to the tree's centroid, patient axes
    Eigen::Vector3d normal;   ///< unit vector pointing outward
};

/// At most `most` sites around the vessels, evenly distributed.
std::vector<WallSite> wallSites(const TreeSamples& tree, std::size_t most);

/// Agreement of vessel walls with the image gradients backprojected along the rays (Markelj 2008).
class BackprojectedGradients {
public:
    BackprojectedGradients(const ImageF& picture, const ProjectionCamera& camera, double blurPx);

    /// |v_B| f(β) at a position in the camera frame (mm) for a wall with this normal; 0 outside the image.
    double agreement(const Eigen::Vector3d& place, const Eigen::Vector3d& normal) const;

    /// Mean agreement of all sites at a pose.
    double score(const std::vector<WallSite>& sites, const CentroidPose& pose) const;

    const ProjectionCamera& camera() const { return camera_; }

private:
    ImageF picture_;
    ProjectionCamera camera_;
};

}   // namespace angiopose::core