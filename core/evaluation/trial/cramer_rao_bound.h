#pragma once

#include "core/geometry/projection_camera.h"
#include "core/geometry/rigid_transform.h"
#include "core/vessel/centerline2d.h"
#include "core/vessel/vessel_tree.h"

namespace angiopose::core {

/// Noise of traced points, the same for both coordinates. The points lie 1 px apart along the curves.
struct TracingNoise {
    double jitterPx = 0.0;   ///< standard deviation per coordinate
    double correlationPoints = 0.0;   ///< distance, in points, at which the noise correlation falls to 1/e
    bool isRasterized = false;   ///< whether the points are then rounded to whole pixels
};

/// Returns the Cramér–Rao bound: the smallest covariance that an unbiased pose estimate from distances normal to the
/// curves can have (ALGORITHMS §6.10), for rotation (rad) and shift (mm) about the tree's centroid in camera axes.
/// `visible` contains the branches of the tree that are in the target.
Matrix6d cramerRaoBound(const VesselTree& tree, const VesselTree& visible, const ProjectionCamera& camera,
                        const RigidTransform& cameraFromPatient, const TracingNoise& noise);

/// Returns the RMS projection distance over the tree's points for a pose error with this covariance, to first order.
double rmsProjectionPx(const VesselTree& tree, const ProjectionCamera& camera, const RigidTransform& cameraFromPatient,
                       const Matrix6d& covariance);

}   // namespace angiopose::core
