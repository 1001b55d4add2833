#pragma once

#include "core/geometry/sight.h"
#include "core/support/result.h"

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace angiopose::io {

/// Matrices and numbers by their names, row by row, as calibration tools write them.
using NamedMatrices = std::map<std::string, std::vector<double>, std::less<>>;

/// All that are numbers in a JSON object: plain, nested rows, or with their values in `data`. The text is valid JSON.
NamedMatrices matricesOfJson(std::string_view json);

/// Whether they tell a camera with its pose, by any of the usual names.
bool reportSight(const NamedMatrices& matrices);

/// P alone, or K with R (or rvec) and t; the image size where it is said, else 0. The message of a failure names no
/// file.
core::Result<core::Sight> sightOf(const NamedMatrices& matrices);

}   // namespace angiopose::io
