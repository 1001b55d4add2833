#pragma once

#include "core/imaging/volume.h"
#include "core/tracing/volume/great_vessels/great_vessels.h"

#include <vector>

namespace angiopose::core {

/// A great vessel that was not traced, beside one that was.
struct OtherLumen {
    double besideMm = 0.0;   ///< how far
    Eigen::Vector3d placeInPatient = Eigen::Vector3d::Zero();   ///< on its axis, amid that stretch
};

/// Where a great vessel that is not in `lumen` runs along one that is, with no more than a wall between: the lumens of
/// a torn aorta do over most of their length, pulmonary arteries cross it. The longest of all.
OtherLumen otherLumenBeside(const VoxelMask& lumen, const std::vector<GreatVessel>& greatVessels);

}   // namespace angiopose::core