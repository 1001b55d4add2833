#pragma once

#include "core/exchange/diffdrr_view.h"
#include "core/support/result.h"

#include <optional>
#include <string>
#include <string_view>

namespace angiopose::io {

/// Parts of a DiffDRR or xvr view found in a file; another file may supply the missing parts.
struct DiffDrrParts {
    std::optional<core::DiffDrrDetector> detector;
    std::optional<core::RigidTransform> pose;
    std::optional<Eigen::Vector3d> volumeCenterInPatient;   ///< center of the volume, LPS mm
};

/// Parses JSON with the keys of DiffDRR, at the top level or in `drr` (FORMATS §3.4). Errors name the invalid key.
core::Result<DiffDrrParts> parseDiffDrrJson(std::string_view text, const std::string& path);

/// Parses the last row of a table with the columns `r1,r2,r3,tx,ty,tz`, which xvr writes for its iterations: Euler
/// angles about Z, X, Y in rad.
core::Result<DiffDrrParts> parseDiffDrrTable(std::string_view text, const std::string& path);

std::string diffDrrText(const core::DiffDrrView& view);

}   // namespace angiopose::io
