#pragma once

#include "core/support/result.h"
#include "core/vessel/vessel_tree.h"

#include <vector>

namespace angiopose::core {

/// A short straight piece of a vessel.
struct VesselPiece {
    Eigen::Vector3d middleInPatient;   ///< mm
    Eigen::Vector3d alongMm;   ///< from its begin to its end
    double radiusMm = 0.0;
    int branchId = 0;
};

/// Radius of vessels whose tree does not tell it, mm.
inline constexpr double assumedRadiusMm = 1.0;

/// The tree in pieces of at most a millimetre.
std::vector<VesselPiece> vesselPiecesOf(const VesselTree& tree);

/// Those of one branch.
std::vector<VesselPiece> piecesOfBranch(const std::vector<VesselPiece>& pieces, int branchId);

/// Where a branch takes off: the pieces within `reachMm` of the bifurcation nearest to its first point, of all branches
/// that meet there. Fails for a branch that the tree does not have, or that meets no other.
Result<std::vector<VesselPiece>> piecesOfTakeOff(const VesselTree& tree, int branchId, double reachMm = 10.0);

}   // namespace angiopose::core
