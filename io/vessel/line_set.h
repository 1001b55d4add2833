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
    std::vector<Eigen::Vector3d> points;   ///< point coordinates as stored in the file
    std::vector<double> radius;   ///< one radius per point; may be empty
    std::vector<std::vector<std::size_t>> lines;   ///< lines as indices into `points`
    std::vector<int> ids;   ///< one ID per line, not necessarily unique; may be empty
    std::vector<std::string> names;   ///< one name per line; may be empty
    core::Messages warnings;
    std::set<std::size_t> junctions;   ///< indices of points at which branches end, even if only two lines meet there
    bool hasSurface = false;   ///< whether the file also contains polygons
};

/// Vessel tree, with the warnings of its reader.
struct LoadedTree {
    core::VesselTree tree;
    core::Messages warnings;
    bool isUnitStated = false;   ///< whether the file states its unit
};

/// Limits beyond which a file is not accepted as a centerline file.
inline constexpr std::size_t maxCenterlinePoints = 200'000;
inline constexpr std::size_t maxCenterlineBranches = 5'000;

/// Converts a line set in LPS mm to branches: cuts lines at jumps or rotates their point order, chains two-point
/// segments, keeps shared trunks once, and makes IDs unique. Fails if indices are out of range, values are NaN, there
/// are no lines, or findProblem(tree) reports a problem.
core::Result<LoadedTree> treeFromLines(LineSet set, const std::string& path);

/// Joins two-point segments into the longest chains without a bifurcation or meeting point; longer lines stay
/// unchanged. Never joins lines with different IDs or names.
LineSet chainSegments(const LineSet& set);

/// Returns a name that every format can store: a single line, trimmed, with control characters replaced by blanks.
std::string sanitizedBranchName(std::string_view text);

}   // namespace angiopose::io
