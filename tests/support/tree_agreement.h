#pragma once

#include "core/vessel/vessel_tree.h"

#include <optional>

namespace angiopose::test {

/// How a traced tree agrees with the true one.
struct TreeAgreement {
    double found = 0.0;   ///< share of the true length that lies within the vessel's radius of the traced curve
    double right = 0.0;   ///< share of the traced length that lies within the vessel's radius of a true curve
    double overlap = 0.0;   ///< both together (OV of Schaap et al. 2009)
    double meanDistanceMm = 0.0;   ///< from the traced curve to the true one, where it is right
    double radiusError = 0.0;   ///< mean of |traced - true| / true, where it is right
};

/// `minReachMm` is the least distance that counts as within a vessel (a voxel).
TreeAgreement agreementOf(const core::VesselTree& traced, const core::VesselTree& truth, double minReachMm);

/// Traced less true radius, median over the stretch of a simulated branch that carries its stent; none where less than
/// half of it is traced.
std::optional<double> radiusErrorInStentMm(const core::VesselTree& traced, const core::VesselBranch& stented);

/// From `point` to the curves of `tree`, mm.
double distanceTo(const core::VesselTree& tree, const Eigen::Vector3d& point);

/// Share of `tree`'s points within `reachMm` of `other`.
double shareNear(const core::VesselTree& tree, const core::VesselTree& other, double reachMm);

}   // namespace angiopose::test