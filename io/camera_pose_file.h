#pragma once

#include "core/geometry/projection_camera.h"
#include "core/geometry/rigid_transform.h"

#include <string>

namespace angiopose::io {

/// Pose and camera as JSON, every double to the last bit: a pose file (readPose) with the key `camera` of a case file.
std::string cameraPoseText(const core::RigidTransform& cameraFromPatient, const core::ProjectionCamera& camera);

}   // namespace angiopose::io
