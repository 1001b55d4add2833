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
    double fill = 1.0;   ///< mean on the axis: 1 as the blood of the scan

    double medianRadiusMm() const;
    double slenderness() const;   ///< length in its greatest radius

    /// How much it is like an aorta or another main artery: long, wide, along the body and well
    /// filled: a false lumen and veins often are less so.
    double worth() const;

    bool operator==(const Trunk&) const = default;
};

/// The stretches that look like great vessels: cross-sections round, width changing slowly from one to the next, longer
/// than wide. That of the greatest worth comes first. Found by walking both ways from the widest places of `lumen`,
/// whose distances are given. Incomplete when stopped.
std::vector<Trunk> findTrunks(const CoarseBlood& blood, const DistanceMap& distances, TracingProgress& progress);

}   // namespace angiopose::core