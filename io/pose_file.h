#pragma once

#include "core/geometry/rigid_transform.h"
#include "core/support/result.h"

#include <Eigen/Core>
#include <string>

namespace angiopose::io {

/// Reads a pose from `.json` (`cameraFromPatient` at the top level, or in `pose`), or from an ITK `.tfm`, `.mat` or
/// `.h5`. Our ITK transforms map patient points to camera points (LPS mm), as the comment in the file states.
core::Result<core::RigidTransform> readPose(const std::string& path);

/// Writes JSON, `.tfm` or `.h5`, depending on the extension, with full double precision.
core::Status writePose(const core::RigidTransform& cameraFromPatient, const std::string& path);

}   // namespace angiopose::io
