#pragma once

#include "core/geometry/sight.h"
#include "core/support/result.h"

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace angiopose::io {

/// Matrices and numbers by name, row-major, as calibration tools write them.
using NamedMatrices = std::map<std::string, std::vector<double>, std::less<>>;

/// Returns all numeric members of a JSON object: plain, nested rows, or with their values in `data`. The text must be
/// valid JSON.
NamedMatrices matricesOfJson(std::string_view json);

/// Returns whether the matrices describe a camera with its pose, under any of the usual names.
bool reportSight(const NamedMatrices& matrices);

/// Builds the camera and pose from P alone, or from K with R (or rvec) and t; the image size is 0 if not stated. The
/// error message names no file.
core::Result<core::Sight> sightOf(const NamedMatrices& matrices);

}   // namespace angiopose::io
