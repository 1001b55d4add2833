#pragma once

#include "core/measuring/target_points.h"
#include "core/support/result.h"

#include <string>

namespace angiopose::io {

/// Returns the target points and rings of a case as CSV (FORMATS §4), at the case's poses: one row per view in which a
/// target point is marked, with its error in that view and the uncertainty stated by the result; one row for the 3-D
/// error if two views determine it; one row for a point that is not marked in any view.
std::string targetPointTable(const core::Case& session);
core::Status writeTargetPoints(const core::Case& session, const std::string& path);

/// Returns the rows of targetPointTable as a JSON array (FORMATS §3).
std::string targetPointJson(const core::Case& session);

}   // namespace angiopose::io
