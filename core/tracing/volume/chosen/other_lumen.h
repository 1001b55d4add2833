#pragma once

#include "core/imaging/volume.h"
#include "core/tracing/volume/great_vessels/great_vessels.h"

#include <vector>

namespace angiopose::core {

/// A great vessel that was not traced, next to one that was.
struct OtherLumen {
    double besideMm = 0.0;   ///< length of the stretch along the traced vessel
    Eigen::Vector3d placeInPatient = Eigen::Vector3d::Zero();   ///< on its axis, in the middle of that stretch
};

/// Finds a great vessel outside `lumen` that runs alongside one inside it with no more than a wall between them: the
/// two lumens of an aortic dissection do so over most of their length, whereas pulmonary arteries cross the aorta.
/// Returns the longest one.
OtherLumen otherLumenBeside(const VoxelMask& lumen, const std::vector<GreatVessel>& greatVessels);

}   // namespace angiopose::core