#pragma once

#include "core/measuring/check_points.h"
#include "core/support/result.h"

#include <string>

namespace angiopose::io {

/// Check points and rings of a case as a comma-separated table (FORMATS §4), at the case's poses: a row for each view
/// that a check point was pointed at in, with its error there beside what the result claims, one for the error in space
/// where two views tell of it, and one for what was pointed at nowhere.
std::string checkPointTable(const core::Case& session);
core::Status writeCheckPoints(const core::Case& session, const std::string& path);

/// The same as a JSON array (FORMATS §3).
std::string checkPointJson(const core::Case& session);

}   // namespace angiopose::io
