#pragma once

#include "core/tracing/volume/great_vessels/coarse_blood.h"
#include "core/tracing/volume/voxels/distance_map.h"
#include "core/tracing/volume/voxels/tracing_progress.h"

#include <Eigen/Core>
#include <vector>

namespace angiopose::core {

/// A long stretch of vessel, wide for its scan.
struct Trunk {
    std::vector<Eigen::Vector3d> pointsInPatient;   ///< on its axis, LPS mm
    std::vector<double> radiusMm;
    double fill = 1.0;   ///< mean along the axis; 1: as bright as the scan's blood

    double medianRadiusMm() const;
    double slenderness() const;   ///< length relative to its largest radius

    /// Resemblance to an aorta or another main artery: long, wide, aligned with the body and well opacified; a false
    /// lumen and veins are often less so.
    double worth() const;

    bool operator==(const Trunk&) const = default;
};

/// Finds vessel stretches that look like great vessels: round cross-sections, width changing slowly from one to the
/// next, longer than wide; the one of highest worth comes first. Tracks both ways from the widest places of `lumen`,
/// whose distances are given. Incomplete when stopped.
std::vector<Trunk> findTrunks(const CoarseBlood& blood, const DistanceMap& distances, TracingProgress& progress);

}   // namespace angiopose::core