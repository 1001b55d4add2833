#pragma once

#include "core/imaging/volume.h"
#include "core/vessel/vessel_tree.h"

#include <string>
#include <vector>

namespace angiopose::benchmarks {

struct NamedMask {
    std::string name;
    core::VoxelMask mask;
};

/// Draws the vessels as balls along their curves, with a margin of some voxels.
core::VoxelMask drawnVessels(const core::VesselTree& tree, double voxelMm);

/// Vessel masks and labels, and voxelized surfaces, from the folder of test data.
std::vector<NamedMask> givenMasks();

/// Trees of patients drawn as tubes: cerebral arteries with their circle of Willis, both coronary arteries with and
/// without the aorta. The test set.
std::vector<NamedMask> masksOfPatients();

/// Trees of the simulator drawn as tubes: alone, two side by side, cut into pieces, cropped. For choosing constants.
std::vector<NamedMask> grownMasks(int count);

}   // namespace angiopose::benchmarks
