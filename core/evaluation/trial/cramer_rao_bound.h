#pragma once

#include "core/geometry/projection_camera.h"
#include "core/geometry/rigid_transform.h"
#include "core/vessel/centerline2d.h"
#include "core/vessel/vessel_tree.h"

namespace angiopose::core {

/// Noise of traced points, equal for both coordinates; points are 1 px apart along the curves.
struct TracingNoise {
    double jitterPx = 0.0;   ///< σ
    double correlationPoints = 0.0;   ///< distance, in points, at which the noise correlation falls to 1/e
    bool isRasterized = false;   ///< whether points are rounded to whole pixels afterwards
};

/// Returns the smallest covariance of any unbiased pose estimate from the curves' normal distances (ALGORITHMS §6.10):
/// rotation (rad) and shift (mm) about the tree's centroid in camera axes. `visible` are the branches of the tree in
/// the target.
Matrix6d cramerRaoBound(const VesselTree& tree, const VesselTree& visible, const ProjectionCamera& camera,
                        const RigidTransform& cameraFromPatient, const TracingNoise& noise);

/// Returns the root mean square projection distance over the tree's points for a pose error of this covariance, to
/// first order.
double rmsProjectionPx(const VesselTree& tree, const ProjectionCamera& camera, const RigidTransform& cameraFromPatient,
                       const Matrix6d& covariance);

}   // namespace angiopose::core