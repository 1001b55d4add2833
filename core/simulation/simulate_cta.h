#pragma once

#include "core/imaging/volume.h"
#include "core/simulation/simulated_case.h"

#include <cstdint>

namespace angiopose::core {

/// A CT angiogram as a scanner would give it, in HU.
struct CtaOptions {
    Eigen::Vector3i size = {256, 256, 220};
    Eigen::Vector3d spacingMm = {0.7, 0.7, 0.8};
    double bloodHu = 380.0;
    double noiseHu = 25.0;   ///< standard deviation, after reconstruction
    double blurVoxels = 0.6;   ///< standard deviation of the point spread
    int calcificationCount = 12;   ///< in the walls
    bool hasStent = false;   ///< in the first branch
};

struct SimulatedCta {
    Volume volume;   ///< axes along the patient's, LPS
    VesselTree tree;   ///< what was filled, around the middle of the volume
};

/// The tree that `simulateCta` grows: as wished, but no larger than the scan has room for. simulateCase of these
/// options and the same seed is an angiogram of the same vessels.
TreeOptions treeInScan(const TreeOptions& tree, const CtaOptions& cta);

/// A grown tree in a body of fat, muscle and organs with spine, ribs and the scanner's table: partial volume, blur and
/// noise. The tree fills about three quarters of the scan; bone lies close to it. Same seed, same bits.
SimulatedCta simulateCta(std::uint64_t seed, const TreeOptions& tree = {}, const CtaOptions& cta = {});

}   // namespace angiopose::core