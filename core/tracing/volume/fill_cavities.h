#pragma once

#include "core/imaging/volume.h"

namespace core {

/// Sets to 2 what is enclosed by the mask: thinning would leave a shell around it. What was set becomes 1.
void fillCavities(VoxelMask& mask);

/// Sets to 2 what most neighbours of are set; larger holes take several rounds. Noise makes holes that are open to a
/// side, and thinning would leave a loop around each. Walls of vessels stay where they are.
void fillHoles(VoxelMask& mask);

}   // namespace core
