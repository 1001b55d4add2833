#pragma once

#include "core/support/result.h"
#include "core/vessel/vessel_tree.h"

#include <Eigen/Core>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace angiopose::io {

/// Poly-lines as files hold them, before they become branches.
struct LineSet {
    std::vector<Eigen::Vector3d> points;   ///< as in the file
    std::vector<double> radius;   ///< one per point, or empty
    std::vector<std::vector<std::size_t>> lines;   ///< indices into `points`
    std::vector<int> ids;   ///< one per line, may repeat; or empty
    std::vector<std::string> names;   ///< one per line, or empty
    core::Messages warnings;
    std::set<std::size_t> meetings;   ///< points that end branches, though no more than two lines may meet there
    bool hasSurface = false;   ///< polygons were there too
};

/// A tree, and what its reader noticed.
struct ReadTree {
    core::VesselTree tree;
    core::Messages warnings;
    bool isUnitStated = false;   ///< by the file
};

/// More points than this are no centreline.
inline constexpr std::size_t maxCenterlinePoints = 200'000;
inline constexpr std::size_t maxCenterlineBranches = 5'000;

/// Branches of a line set in LPS mm: lines that leap cut or turned round, two-point segments chained, shared trunks
/// once, ids kept where they are unique. Fails on indices out of range, NaN, no lines, or what findProblem(tree) says.
core::Result<ReadTree> treeFromLines(LineSet set, const std::string& path);

/// Joins segments of two points into the longest runs without a bifurcation or meeting; longer lines stay as they are.
/// Lines of different ids or names are never joined.
LineSet chainSegments(const LineSet& set);

/// A name as every format can hold it: one line, its control characters blanks, none at its ends.
std::string branchName(std::string_view text);

}   // namespace angiopose::io