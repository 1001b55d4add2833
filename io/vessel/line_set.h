#pragma once

#include "core/support/result.h"
#include "core/vessel/vessel_tree.h"

#include <Eigen/Core>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace angiopose::io {

/// Polylines as stored in files, before they become branches.
struct LineSet {
    std::vector<Eigen::Vector3d> points;   ///< as in the file
    std::vector<double> radius;   ///< one per point, or empty
    std::vector<std::vector<std::size_t>> lines;   ///< indices into `points`
    std::vector<int> ids;   ///< one per line, not necessarily unique; or empty
    std::vector<std::string> names;   ///< one per line, or empty
    core::Messages warnings;
    std::set<std::size_t> meetings;   ///< points at which branches end, even if only two lines meet there
    bool hasSurface = false;   ///< the file also contained polygons
};

/// A tree, and the observations of its reader.
struct ReadTree {
    core::VesselTree tree;
    core::Messages warnings;
    bool isUnitStated = false;   ///< the file states its unit
};

/// Limits above which a file is not accepted as centerlines.
inline constexpr std::size_t maxCenterlinePoints = 200'000;
inline constexpr std::size_t maxCenterlineBranches = 5'000;

/// Converts a line set in LPS mm to branches: cuts lines at leaps or rotates their point order, chains two-point
/// segments, keeps shared trunks once, and keeps unique ids. Fails on indices out of range, NaN, no lines, or a problem
/// reported by findProblem(tree).
core::Result<ReadTree> treeFromLines(LineSet set, const std::string& path);

/// Joins two-point segments into the longest chains without a bifurcation or meeting point; longer lines are unchanged.
/// Never joins lines of different ids or names.
LineSet chainSegments(const LineSet& set);

/// Returns a name that every format can store: one line, control characters replaced by blanks, trimmed.
std::string branchName(std::string_view text);

}   // namespace angiopose::io