#pragma once

#include "core/imaging/volume.h"
#include "core/vessel/vessel_tree.h"

#include <string>
#include <vector>

namespace angiopose::benchmarks {

/// A mask of vessels to be traced.
struct NamedMask {
    std::string name;
    core::VoxelMask mask;
};

/// The vessels as balls along their curves, with a margin of some voxels around.
core::VoxelMask drawnVessels(const core::VesselTree& tree, double voxelMm);

/// Masks and labels of vessels, and surfaces filled with voxels, of the folder of test data.
std::vector<NamedMask> givenMasks();

/// Trees of patients drawn as tubes: cerebral arteries with their circle of Willis, both coronary arteries with and
/// without the aorta. These judge.
std::vector<NamedMask> masksOfPatients();

/// Trees of the simulator drawn as tubes: alone, two beside each other, cut in pieces, crossed by a crop. For choosing
/// constants.
std::vector<NamedMask> grownMasks(int count);

}   // namespace angiopose::benchmarks
