#pragma once

#include "core/imaging/image2d.h"
#include "core/registration/pose/centroid_pose.h"
#include "core/registration/problem/registration_problem.h"

namespace angiopose::core {

/// Point on a vessel wall, with the wall normal, along which a CT has its gradient.
struct WallSite {
    Eigen::Vector3d position;   ///< offset from the tree's centroid, mm, patient axes
    Eigen::Vector3d normal;   ///< unit vector pointing outward
};

/// Returns about `maxSites` evenly distributed points on the vessel walls.
std::vector<WallSite> wallSites(const TreeSamples& tree, std::size_t maxSites);

/// Measures how well vessel walls agree with image gradients that are backprojected along the rays (Markelj 2008).
class BackprojectedGradients {
public:
    BackprojectedGradients(const ImageF& image, const ProjectionCamera& camera, double blurPx);

    /// Returns |v_B| f(β) at a position in the camera frame (mm) for a wall with this normal; 0 outside the image.
    double agreement(const Eigen::Vector3d& position, const Eigen::Vector3d& normal) const;

    /// Returns the mean agreement over all wall points at a pose.
    double score(const std::vector<WallSite>& sites, const CentroidPose& pose) const;

    const ProjectionCamera& camera() const { return camera_; }

private:
    ImageF image_;
    ProjectionCamera camera_;
};

}   // namespace angiopose::core
