#pragma once

#include "core/imaging/volume.h"

namespace core {

/// Sets what is enclosed by the mask: thinning would leave a shell around it.
void fillCavities(VoxelMask& mask);

}   // namespace core
