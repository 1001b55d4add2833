#pragma once

#include "angiopose/error.h"
#include "angiopose/export.h"

#include <Eigen/Core>
#include <string>
#include <vector>

namespace angiopose {

/// Name and generation of one branch.
struct BranchLabel {
    int id = 0;
    std::string name;
    int generation = -1;   ///< 0 for a branch that starts at the root, 1 for its side branches, …; -1 if unknown
};

/// Centerlines of a vessel tree; row i of each array belongs to point i. The points of a branch are contiguous and
/// ordered along the vessel. Connected branches need not share a point.
struct VesselTree {
    std::vector<Eigen::Vector3d> points;   ///< N points (LPS, mm)
    std::vector<int> branchIds;   ///< N; branch ID of each point, arbitrary but unique per branch
    std::vector<double> radiusMm;   ///< N radii, or empty; ≥ 0, or NaN along an entire branch whose radii are unknown
    std::vector<BranchLabel> labels;   ///< labels of the named branches, in any order; may be empty
};

/// Vessels in an angiogram as points; row i of each array belongs to point i.
struct Centerline2d {
    std::vector<Eigen::Vector2d> points;   ///< M points, px
    /// M; curve ID of each point. The points of a curve are contiguous and ordered along it. If empty, the points are
    /// unordered, e.g. the pixels of a skeleton, and neighboring points are joined into curves. (In files, the order of
    /// the rows is the order of the points.)
    std::vector<int> curveIds;
    std::vector<double> radiusPx;   ///< M radii, or empty; NaN along a curve whose radii are unknown
};

/// Reads VTP/VTU, legacy VTK, CSV, SWC or Slicer curves. `unitMm` is the length in mm of one unit of the file; if 0,
/// the unit is the one stated in the file, or mm.
ANGIOPOSE_EXPORT VesselTree readVesselTree(const std::string& path, double unitMm = 0.0);

/// Writes .vtp, .csv, .swc or .mrk.json (without radii), depending on the extension.
ANGIOPOSE_EXPORT void writeVesselTree(const VesselTree& tree, const std::string& path);

/// Reads a CSV file (`x,y,branch,radius`) or traces a PNG mask.
ANGIOPOSE_EXPORT Centerline2d readCenterline2d(const std::string& path);

/// Writes a CSV file with the columns `x,y,branch,radius`, px.
ANGIOPOSE_EXPORT void writeCenterline2d(const Centerline2d& centerline, const std::string& path);

}   // namespace angiopose
