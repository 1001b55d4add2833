#pragma once

#include "core/geometry/rigid_transform.h"
#include "core/support/result.h"

#include <string>
#include <string_view>

namespace io {

/// Pose in ITK's text transform format: a 3-D affine, Euler or versor transform that maps patient to camera points.
core::Result<core::RigidTransform> poseOfItkText(std::string_view text, const std::string& path);

/// The pose as an AffineTransform_double_3_3 about the origin; every double restores to the last bit.
std::string itkTextOf(const core::RigidTransform& cameraFromPatient);

}   // namespace io
