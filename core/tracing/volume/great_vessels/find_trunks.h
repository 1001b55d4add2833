#pragma once

#include "core/tracing/volume/great_vessels/block_opacification.h"
#include "core/tracing/volume/voxels/distance_map.h"
#include "core/tracing/volume/voxels/tracing_progress.h"

#include <Eigen/Core>
#include <vector>

namespace angiopose::core {

/// Long vessel section that is wide for its scan.
struct Trunk {
    std::vector<Eigen::Vector3d> pointsInPatient;   ///< centerline points, LPS, mm
    std::vector<double> radiusMm;
    double fill = 1.0;   ///< mean opacification along the centerline; 1 is the lumen level of the scan

    double medianRadiusMm() const;
    double slenderness() const;   ///< length divided by the largest radius

    /// Returns a score for the resemblance to an aorta or another main artery: long, wide, aligned with the body axis
    /// and well opacified; false lumens and veins often score lower.
    double score() const;

    bool operator==(const Trunk&) const = default;
};

/// Finds vessel sections that look like great vessels (round cross-sections, slowly changing width, longer than wide),
/// highest score first. Tracks in both directions from the widest points of the lumen, whose distance map is given.
/// Incomplete when stopped.
std::vector<Trunk> findTrunks(const BlockOpacification& blocks, const DistanceMap& distances,
                              TracingProgress& progress);

}   // namespace angiopose::core
