#pragma once

#include "core/measuring/branch_profile.h"
#include "core/support/result.h"

#include <string>

namespace angiopose::io {

/// Returns the measurements of all branches of a tree as CSV (FORMATS §4), one row per branch. Unknown values are
/// empty; the notes column gives the reason.
std::string branchTable(const core::VesselTree& tree);

/// Returns samples along a branch as CSV: arc length, patient LPS, diameter, reference diameter (mm), curvature (1/mm).
std::string profileTable(const core::BranchProfile& profile);

core::Status writeBranchTable(const core::VesselTree& tree, const std::string& path);
core::Status writeProfile(const core::BranchProfile& profile, const std::string& path);

}   // namespace angiopose::io
