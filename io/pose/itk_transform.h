#pragma once

#include "core/geometry/rigid_transform.h"
#include "core/support/result.h"

#include <string>
#include <string_view>

namespace angiopose::io {

/// Parses the single transform of an ITK text file: Euler3D, VersorRigid3D or affine (if rigid), including its center.
/// The error does not name the file.
core::Result<core::RigidTransform> poseFromItkText(std::string_view text);

/// Parses the transform of a `.mat` file. Does not use ITK's reader, which writes past its buffers on damaged files.
core::Result<core::RigidTransform> poseFromItkMatlab(std::string_view content);

/// Returns the pose as an ITK text file that maps patient points (LPS) to camera points, mm.
std::string itkText(const core::RigidTransform& cameraFromPatient);

}   // namespace angiopose::io
