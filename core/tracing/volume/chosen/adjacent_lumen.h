#pragma once

#include "core/imaging/volume.h"
#include "core/tracing/volume/great_vessels/great_vessels.h"

#include <vector>

namespace angiopose::core {

/// Untraced great vessel alongside a traced one, e.g. the second lumen of a dissection.
struct AdjacentLumen {
    double adjacentMm = 0.0;   ///< length of the section alongside the traced vessel
    Eigen::Vector3d positionInPatient = Eigen::Vector3d::Zero();   ///< centerline point in the middle of that section
};

/// Returns the longest great vessel outside `lumen` that runs alongside one inside, separated by no more than a wall.
/// The two lumens of an aortic dissection do so over most of their length, whereas pulmonary arteries cross the aorta.
AdjacentLumen possibleFalseLumen(const VoxelMask& lumen, const std::vector<GreatVessel>& greatVessels);

}   // namespace angiopose::core
