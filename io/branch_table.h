#pragma once

#include "core/measuring/branch_profile.h"
#include "core/support/result.h"

#include <string>

namespace angiopose::io {

/// Measures along every branch of a tree as a comma-separated table (FORMATS §4), a row each; what is not known stays
/// empty, the notes say why.
std::string branchTable(const core::VesselTree& tree);

/// Places along one branch: arc length, patient LPS, diameter, reference (mm) and curvature (1/mm).
std::string profileTable(const core::BranchProfile& profile);

core::Status writeBranchTable(const core::VesselTree& tree, const std::string& path);
core::Status writeProfile(const core::BranchProfile& profile, const std::string& path);

}   // namespace angiopose::io
