#pragma once

#include "core/support/result.h"
#include "core/vessel/vessel_tree.h"

#include <optional>
#include <vector>

namespace angiopose::core {

/// A sample along a branch. NaN values are unknown.
struct ProfileSample {
    double arcLengthMm = 0.0;   ///< arc length from the branch's first point
    Eigen::Vector3d pointInPatient = Eigen::Vector3d::Zero();   ///< LPS, mm
    double diameterMm = 0.0;   ///< twice the radius in the tree, median over 2 mm
    double referenceDiameterMm = 0.0;   ///< diameter expected in a healthy vessel, see measureProfile
    double curvaturePerMm = 0.0;   ///< inverse of the radius of curvature, measured over 6 mm
};

/// The narrowest point of a branch relative to its reference diameter.
struct StenosisMeasure {
    double percent = 0.0;   ///< diameter stenosis in %; 0 if not narrower than the reference
    double positionMm = 0.0;
    double fromMm = 0.0;   ///< start and end of the stenosis, where the diameter reaches 90 % of the reference
    double toMm = 0.0;
    double diameterMm = 0.0;
    double referenceDiameterMm = 0.0;
};

/// Measurements of one branch.
struct BranchProfile {
    int branchId = 0;
    std::vector<ProfileSample> samples;   ///< ordered along the branch, 0.5 mm apart, including both ends
    double lengthMm = 0.0;
    double tortuosity = 1.0;   ///< length over distance between the ends; 1 if straight, NaN for a closed loop
    double maxCurvaturePerMm = 0.0;   ///< NaN for branches shorter than 2 mm
    std::optional<double> meanDiameterMm;   ///< mean over the branch length; not set without radii
    std::optional<double> minDiameterMm;
    std::optional<double> maxDiameterMm;
    std::optional<StenosisMeasure> stenosis;   ///< not set without a reference diameter
    Messages warnings;   ///< messages about measurements that failed, with the reason
};

/// Measures diameter, curvature, tortuosity and the narrowest point of a branch. The reference at a sample is a line
/// through the consistent diameters within 60 mm around it (outliers are removed iteratively), so a vessel may taper;
/// if the vessel does not return to this line within 20 mm, the reference is the diameter to which it returns. One
/// diameter at each end of the branch is excluded, because traced radii extend into the parent vessel or beyond the
/// lumen there. Fails on a branch with fewer than two points or without length; without radii, measures the rest and
/// adds a message.
Result<BranchProfile> measureProfile(const VesselBranch& branch);

}   // namespace angiopose::core
