#pragma once

#include "core/exchange/diffdrr_view.h"
#include "core/support/result.h"

#include <optional>
#include <string>
#include <string_view>

namespace angiopose::io {

/// What a file says of a view of DiffDRR or xvr; what it lacks may come from another.
struct DiffDrrParts {
    std::optional<core::DiffDrrDetector> detector;
    std::optional<core::RigidTransform> pose;
    std::optional<Eigen::Vector3d> volumeCenterInPatient;   ///< LPS mm
};

/// JSON with the keys of DiffDRR, at the top or in `drr` (FORMATS §3.4). Fails naming the key that is wrong.
core::Result<DiffDrrParts> diffDrrOfJson(std::string_view text, const std::string& path);

/// The last row of a table with `r1,r2,r3,tx,ty,tz` as xvr writes of its way: Euler angles about Z, X, Y in rad.
core::Result<DiffDrrParts> diffDrrOfTable(std::string_view text, const std::string& path);

std::string diffDrrText(const core::DiffDrrView& view);

}   // namespace angiopose::io
