#pragma once

#include "core/geometry/projection_camera.h"
#include "core/geometry/rigid_transform.h"
#include "core/vessel/tree_knots.h"

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace angiopose::core {

/// Projection of knots at one pose.
struct ProjectedKnots {
    std::vector<Eigen::Vector2d> pixels;   ///< far outside the image for knots that do not project
    std::vector<double> radiusMm;   ///< vessel radius; 0 if unknown
    double mmPerPx = 1.0;   ///< at the depth of the tree

    std::size_t size() const { return pixels.size(); }
};

/// Projects the knots with the indices `which`, in that order. `depthMm` is the distance of the tree from the source.
ProjectedKnots projectWireKnots(const TreeKnots& knots, const std::vector<std::size_t>& knotIndices,
                                const ProjectionCamera& camera, const RigidTransform& cameraFromPatient,
                                double depthMm);

}   // namespace angiopose::core
