#pragma once

#include "core/vessel/vessel_tree.h"

#include <optional>

namespace angiopose::test {

struct TreeAgreement {
    double found = 0.0;   ///< share of the true length within the vessel's radius of the traced curve
    double right = 0.0;   ///< share of the traced length within the vessel's radius of a true curve
    double overlap = 0.0;   ///< combination of the two (OV of Schaap et al. 2009)
    double meanDistanceMm = 0.0;   ///< from the traced curve to the true one, over the correct part
    double radiusError = 0.0;   ///< mean of |traced - true| / true, over the correct part
};

/// Compares two trees; `minReachMm` is the smallest distance that counts as within a vessel (one voxel).
TreeAgreement agreementOf(const core::VesselTree& traced, const core::VesselTree& truth, double minReachMm);

/// Traced minus true radius, median over the stented section of a simulated branch; nullopt if less than half of it is
/// traced.
std::optional<double> radiusErrorInStentMm(const core::VesselTree& traced, const core::VesselBranch& stented);

/// Distance from `point` to the curves of `tree`, mm.
double distanceTo(const core::VesselTree& tree, const Eigen::Vector3d& point);

/// Share of `tree`'s points within `reachMm` of `other`.
double shareNear(const core::VesselTree& tree, const core::VesselTree& other, double reachMm);

}   // namespace angiopose::test
