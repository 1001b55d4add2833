#pragma once

#include "core/geometry/rigid_transform.h"
#include "core/support/result.h"

#include <Eigen/Core>
#include <string>

namespace angiopose::io {

/// Pose from `.json` (`cameraFromPatient` at the top, or in `pose`), or an ITK `.tfm`, `.mat` or `.h5`.
/// Our ITK transforms map patient points to camera points (LPS mm), said in the file's comment.
core::Result<core::RigidTransform> readPose(const std::string& path);

/// Writes JSON, `.tfm` or `.h5`, by extension; every double restores to the last bit.
core::Status writePose(const core::RigidTransform& cameraFromPatient, const std::string& path);

}   // namespace angiopose::io