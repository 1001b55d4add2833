#pragma once

#include "angiopose/error.h"
#include "angiopose/export.h"

#include <Eigen/Core>
#include <string>
#include <vector>

namespace angiopose {

/// What is known of one branch beside its points.
struct BranchLabel {
    int id = 0;
    std::string name;
    int generation = -1;   ///< 0 begins at the root, 1 leaves such a branch, …; -1: not known
};

/// Centrelines of a vessel tree: row i of each array tells of point i. The points of a branch stand together, in order
/// along the vessel. Branches that meet need not share a point.
struct VesselTree {
    std::vector<Eigen::Vector3d> points;   ///< N, patient LPS, mm
    std::vector<int> branchIds;   ///< N, the branch of each point; any numbers, one per branch
    std::vector<double> radiusMm;   ///< N, or empty; 0 and more, or NaN along a whole branch whose radii are not known
    std::vector<BranchLabel> labels;   ///< of branches that have one, in any order; may be empty
};

/// Vessels of an angiogram as points: row i of each array tells of point i.
struct Centerline2d {
    std::vector<Eigen::Vector2d> points;   ///< M, px
    /// M: the curve of each point; those of a curve stand together, in order along it. Empty: the points are in no
    /// order, such as the pixels of a skeleton; neighbours in the image are joined to curves then. (Files are taken in
    /// the order of their rows.)
    std::vector<int> curveIds;
    std::vector<double> radiusPx;   ///< M, or empty; NaN along a curve whose radii are not known
};

/// From VTP/VTU, legacy VTK, CSV, SWC or Slicer curves. `unitMm` is the length of one unit of the file; 0: as the
/// file states, else mm.
ANGIOPOSE_EXPORT VesselTree readVesselTree(const std::string& path, double unitMm = 0.0);

/// To .vtp, .csv, .swc or .mrk.json (without radii), by the extension.
ANGIOPOSE_EXPORT void writeVesselTree(const VesselTree& tree, const std::string& path);

/// From CSV (`x,y,branch,radius`) or a PNG mask, which is traced.
ANGIOPOSE_EXPORT Centerline2d readCenterline2d(const std::string& path);

/// To CSV `x,y,branch,radius`, px.
ANGIOPOSE_EXPORT void writeCenterline2d(const Centerline2d& centerline, const std::string& path);

}   // namespace angiopose
