#pragma once

#include "core/geometry/projection_camera.h"
#include "core/geometry/rigid_transform.h"
#include "core/vessel/centerline2d.h"
#include "core/vessel/vessel_tree.h"

#include <cstdint>

namespace angiopose::core {

/// A generated tree and the camera of the published experiments: f = 1877 px, centroid 800 mm from the source, clinical
/// angles.
struct Phantom {
    VesselTree tree;
    ProjectionCamera camera;
    RigidTransform trueCameraFromPatient;
    Centerline2d target;   ///< resampled curves of the tree, see projectCurves
    Centerline2d exactTarget;   ///< projections of the tree's points, one curve per branch; gives exact correspondences
};

/// Creates the tree with this seed and about `pointCount` points, projected into a square image of `imageSizePx`.
Phantom makePhantom(std::uint64_t seed, int pointCount, int imageSizePx = 512);

}   // namespace angiopose::core
