#pragma once

#include "core/imaging/volume.h"
#include "core/simulation/simulated_case.h"

#include <cstdint>

namespace angiopose::core {

/// Options of a simulated CT angiogram, in HU as from a scanner.
struct CtaOptions {
    Eigen::Vector3i size = {256, 256, 220};
    Eigen::Vector3d spacingMm = {0.7, 0.7, 0.8};
    double bloodHu = 380.0;
    double noiseHu = 25.0;   ///< standard deviation, after reconstruction
    double blurVoxels = 0.6;   ///< standard deviation of the point spread function
    int calcificationCount = 12;   ///< in the vessel walls
    bool hasStent = false;   ///< in the first branch
};

struct SimulatedCta {
    Volume volume;   ///< axes along the patient's axes, LPS
    VesselTree tree;   ///< opacified tree, around the center of the volume
};

/// Returns the options of the tree that `simulateCta` grows: as requested, but limited to the size of the scan.
/// simulateCase with these options and the same seed gives an angiogram of the same vessels.
TreeOptions treeInScan(const TreeOptions& tree, const CtaOptions& cta);

/// Simulates a grown tree in a body of fat, muscle and organs with spine, ribs and the scanner table, including partial
/// volume, blur and noise. The tree fills about three quarters of the scan, close to bone. The same seed gives
/// identical bits.
SimulatedCta simulateCta(std::uint64_t seed, const TreeOptions& tree = {}, const CtaOptions& cta = {});

}   // namespace angiopose::core