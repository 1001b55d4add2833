#pragma once

#include "core/geometry/posed_camera.h"
#include "core/support/result.h"

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace angiopose::io {

/// Row-major matrices and numbers by name, as calibration tools write them.
using NamedMatrices = std::map<std::string, std::vector<double>, std::less<>>;

/// Returns all numeric members of a JSON object: numbers, lists, nested rows, or objects with the values in `data`. The
/// text must be valid JSON.
NamedMatrices parseJsonMatrices(std::string_view json);

/// Returns whether the matrices describe a camera with its pose, under any of the common names.
bool describesCamera(const NamedMatrices& matrices);

/// Builds the camera and pose from P alone, or from K with R (or rvec) and t; the image size is 0 if not stated. The
/// error does not name the file.
core::Result<core::PosedCamera> posedCameraFrom(const NamedMatrices& matrices);

}   // namespace angiopose::io
