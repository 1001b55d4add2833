#pragma once

#include "core/imaging/volume.h"
#include "core/support/result.h"
#include "core/tracing/volume/voxels/tracing_progress.h"
#include "core/vessel/vessel_tree.h"

#include <Eigen/Core>

namespace angiopose::core {

/// One vessel that was traced between two places.
struct VesselPath {
    VesselBranch branch;   ///< from the first to the second place, patient LPS, with radii; without id
    double outsideMm = 0.0;   ///< length on which it runs through nothing like a vessel
    Messages warnings;
};

/// The vessel of a scan between two places in it (patient LPS mm), by a path of least cost through what is as bright as
/// there and dark on both sides (ALGORITHMS §8.9), centred in its cross-sections. For vessels that tracing misses.
/// Fails where a place lies outside the scan or in nothing brighter than what is around it, or no way was found; ends
/// as stopped when the observer says so.
Result<VesselPath> vesselBetween(const Volume& volume, const Eigen::Vector3d& fromInPatient,
                                 const Eigen::Vector3d& toInPatient, const TracingObserver& observe = {});

}   // namespace angiopose::core
