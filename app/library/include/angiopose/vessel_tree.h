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
    int generation = -1;   ///< 0: starts at the root, 1: leaves such a branch, …; -1: unknown
};

/// Centerlines of a vessel tree: row i of each array belongs to point i. The points of a branch are contiguous and in
/// order along the vessel. Connected branches need not share a point.
struct VesselTree {
    std::vector<Eigen::Vector3d> points;   ///< N, patient LPS, mm
    std::vector<int> branchIds;   ///< N, branch id of each point; arbitrary and unique per branch
    std::vector<double> radiusMm;   ///< N, or empty; ≥ 0, or NaN along a whole branch with unknown radii
    std::vector<BranchLabel> labels;   ///< of the labeled branches, in any order; may be empty
};

/// Vessels of an angiogram as points: row i of each array belongs to point i.
struct Centerline2d {
    std::vector<Eigen::Vector2d> points;   ///< M, px
    /// M, curve id of each point; the points of a curve are contiguous and in order along it. Empty: the points are
    /// unordered, such as the pixels of a skeleton, and neighboring points are joined to curves. (For files, the row
    /// order counts.)
    std::vector<int> curveIds;
    std::vector<double> radiusPx;   ///< M, or empty; NaN along a curve with unknown radii
};

/// Reads VTP/VTU, legacy VTK, CSV, SWC or Slicer curves. `unitMm` is the length of one file unit in mm; 0: as stated in
/// the file, else mm.
ANGIOPOSE_EXPORT VesselTree readVesselTree(const std::string& path, double unitMm = 0.0);

/// Writes .vtp, .csv, .swc or .mrk.json (without radii), by the extension.
ANGIOPOSE_EXPORT void writeVesselTree(const VesselTree& tree, const std::string& path);

/// Reads CSV (`x,y,branch,radius`), or a PNG mask, which is traced.
ANGIOPOSE_EXPORT Centerline2d readCenterline2d(const std::string& path);

/// Writes CSV `x,y,branch,radius`, px.
ANGIOPOSE_EXPORT void writeCenterline2d(const Centerline2d& centerline, const std::string& path);

}   // namespace angiopose
