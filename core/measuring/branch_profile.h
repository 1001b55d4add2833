#pragma once

#include "core/support/result.h"
#include "core/vessel/vessel_tree.h"

#include <optional>
#include <vector>

namespace angiopose::core {

/// A place along a branch. Not a number: not known there.
struct ProfileSample {
    double arcMm = 0.0;   ///< from the branch's first point
    Eigen::Vector3d pointInPatient = Eigen::Vector3d::Zero();   ///< LPS, mm
    double diameterMm = 0.0;   ///< twice the tree's radius, the median over 2 mm
    double referenceMm = 0.0;   ///< what the diameter would be in a healthy vessel, see profileOf
    double curvaturePerMm = 0.0;   ///< one over the radius of the bend, over 6 mm
};

/// The place where a branch is narrowest against its reference.
struct Narrowing {
    double percent = 0.0;   ///< of the diameter; 0: no narrower than the reference
    double atMm = 0.0;
    double fromMm = 0.0;   ///< where it begins and ends: within a tenth of the reference
    double toMm = 0.0;
    double diameterMm = 0.0;
    double referenceMm = 0.0;
};

/// Measures along one branch.
struct BranchProfile {
    int branchId = 0;
    std::vector<ProfileSample> samples;   ///< in order, 0.5 mm apart, both ends
    double lengthMm = 0.0;
    double tortuosity = 1.0;   ///< length over the distance of the ends; 1 is straight; not a number for a closed loop
    double greatestCurvaturePerMm = 0.0;   ///< not a number for branches below 2 mm
    std::optional<double> meanDiameterMm;   ///< over the length; nothing without radii
    std::optional<double> minDiameterMm;
    std::optional<double> greatestDiameterMm;
    std::optional<Narrowing> narrowing;   ///< nothing where there is no reference
    Messages doubts;   ///< what could not be measured, and why
};

/// Diameter, curvature, tortuosity and narrowest place of a branch. The reference of a place is a line through the
/// diameters of the 60 mm around it that agree with each other (narrow and wide ones are left out step by step), so
/// that a vessel may taper; where the vessel does not come back to that within 20 mm, it is what it comes back to. One
/// diameter at each end of the branch does not count, where traced radii run into the parent or out. Fails on a branch
/// of less than two points or without length; without radii it measures the rest and says so.
Result<BranchProfile> profileOf(const VesselBranch& branch);

}   // namespace angiopose::core
