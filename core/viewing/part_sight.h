#pragma once

#include "core/geometry/rigid_transform.h"
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

/// How well a part of the vessels is seen from somewhere (ALGORITHMS §5.9).
struct SightQuality {
    double foreshortening = 0.0;   ///< 0: seen in full length, 1: end on
    double overlap = 0.0;   ///< share of its area that other vessels, or itself, lie over, 0…1

    double cost() const { return foreshortening + overlap; }
};

/// A part among the vessels, looked at from many places.
class PartSight {
public:
    /// `part`: some pieces of `all`, at least one. What touches a piece of the part in space does not cover it.
    PartSight(std::vector<VesselPiece> part, std::vector<VesselPiece> all);

    /// Pieces at or behind the source count as end on and covered.
    SightQuality from(const RigidTransform& cameraFromPatient) const;

private:
    struct Seen;
    Seen seenFrom(const RigidTransform& cameraFromPatient, const VesselPiece& piece) const;
    std::vector<double> coveredShares(const RigidTransform& cameraFromPatient, const std::vector<Seen>& part) const;

    std::vector<VesselPiece> part_, all_;
    double partLengthMm_ = 0.0;
};

/// What of a branch shall be seen.
enum class SightOf { Branch, TakeOff };

/// A branch, or where it takes off (piecesOfTakeOff), among all vessels of the tree. Fails for a branch that the tree
/// does not have, and for a take-off of one that meets no other.
Result<PartSight> sightOf(const VesselTree& tree, int branchId, SightOf what);

}   // namespace angiopose::core
