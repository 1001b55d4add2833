#pragma once

#include "core/imaging/volume.h"
#include "core/tracing/volume/great_vessels/great_vessels.h"

#include <vector>

namespace angiopose::core {

/// How far, in mm, a great vessel that is not in `lumen` runs along one that is, with no more than a wall between: the
/// lumens of a torn aorta do over most of their length, pulmonary arteries cross it. The longest of all.
double besideLumenMm(const VoxelMask& lumen, const std::vector<GreatVessel>& greatVessels);

}   // namespace angiopose::core