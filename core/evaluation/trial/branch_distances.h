#pragma once

#include "core/geometry/projection_camera.h"
#include "core/geometry/rigid_transform.h"
#include "core/vessel/centerline2d.h"
#include "core/vessel/vessel_tree.h"

#include <map>
#include <vector>

namespace angiopose::core {

/// Returns, for every branch id, the distances in px from the branch's projected points to the nearest traced point, in
/// the order of the points; infinite for points at or behind the source. The map is empty if nothing was traced.
std::map<int, std::vector<double>> branchDistances(const VesselTree& tree, const Centerline2d& target,
                                                   const ProjectionCamera& camera,
                                                   const RigidTransform& cameraFromPatient);

}   // namespace angiopose::core
