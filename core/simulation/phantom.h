#pragma once

#include "core/geometry/projection_camera.h"
#include "core/geometry/rigid_transform.h"
#include "core/vessel/centerline2d.h"
#include "core/vessel/vessel_tree.h"

#include <cstdint>

namespace angiopose::core {

/// One generated tree before the camera of the published experiments: f = 1877 px, centroid 800 mm from the source,
/// clinical angles.
struct Phantom {
    VesselTree tree;
    ProjectionCamera camera;
    RigidTransform trueCameraFromPatient;
    Centerline2d target;   ///< the tree's curves sampled anew, see projectCurves
    Centerline2d exactTarget;   ///< projections of the tree's own points, one curve per branch: exact partners exist
};

/// The tree of this seed with about `pointCount` points, seen on a square image of `imageSizePx`.
Phantom makePhantom(std::uint64_t seed, int pointCount, int imageSizePx = 512);

}   // namespace angiopose::core