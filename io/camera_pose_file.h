#pragma once

#include "core/geometry/projection_camera.h"
#include "core/geometry/rigid_transform.h"

#include <string>

namespace angiopose::io {

/// Returns pose and camera as JSON with all bits of every double: a pose file with the `camera` key of a case file.
std::string cameraPoseText(const core::RigidTransform& cameraFromPatient, const core::ProjectionCamera& camera);

}   // namespace angiopose::io
