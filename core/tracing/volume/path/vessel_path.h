#pragma once

#include "core/imaging/volume.h"
#include "core/support/result.h"
#include "core/tracing/volume/voxels/tracing_progress.h"
#include "core/vessel/vessel_tree.h"

#include <Eigen/Core>

namespace angiopose::core {

/// A vessel traced between two points.
struct VesselPath {
    VesselBranch branch;   ///< from the first to the second point, patient LPS, with radii; no id
    double outsideMm = 0.0;   ///< length through tissue that does not look like a vessel
    Messages warnings;
};

/// Traces the vessel between two points of a scan (patient LPS, mm) along the least-cost path through voxels as bright
/// as at the points and dark on both sides (ALGORITHMS §9.12), centered in its cross-sections. Intended for vessels
/// that automatic tracing missed. Fails if a point lies outside the scan or not in a structure brighter than its
/// surroundings, or if no path is found; returns as stopped if the observer requests it.
Result<VesselPath> traceVesselBetween(const Volume& volume, const Eigen::Vector3d& fromInPatient,
                                      const Eigen::Vector3d& toInPatient, const TracingObserver& observe = {});

}   // namespace angiopose::core
