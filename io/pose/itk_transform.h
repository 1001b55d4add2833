#pragma once

#include "core/geometry/rigid_transform.h"
#include "core/support/result.h"

#include <string>
#include <string_view>

namespace angiopose::io {

/// The one transform of an ITK text file: affine (if rigid), Euler3D or VersorRigid3D, about its centre. The message
/// of a failure does not name the file.
core::Result<core::RigidTransform> poseFromItkText(std::string_view text);

/// The same of a `.mat` file. Read here: ITK's reader writes past its buffers when one is damaged.
core::Result<core::RigidTransform> poseFromItkMatlab(std::string_view content);

/// The pose as an ITK text file that maps patient points (LPS) to camera points, mm.
std::string itkText(const core::RigidTransform& cameraFromPatient);

}   // namespace angiopose::io