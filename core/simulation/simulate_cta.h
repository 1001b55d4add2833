#pragma once

#include "core/imaging/volume.h"
#include "core/simulation/simulated_case.h"

#include <cstdint>

namespace angiopose::core {

/// Options of a simulated CT angiogram; values in HU.
struct CtaOptions {
    Eigen::Vector3i size = {256, 256, 220};
    Eigen::Vector3d spacingMm = {0.7, 0.7, 0.8};
    double bloodHu = 380.0;
    double noiseHu = 25.0;   ///< standard deviation of the noise after reconstruction
    double blurVoxels = 0.6;   ///< standard deviation of the point spread function
    int calcificationCount = 12;   ///< number of calcified plaques in the vessel walls
    bool hasStent = false;   ///< whether the first branch has a stent
};

struct SimulatedCta {
    Volume volume;   ///< axes along the patient's axes, LPS
    VesselTree tree;   ///< opacified tree, centered in the volume
};

/// Returns the tree options with which `simulateCta` grows its tree: the requested ones, limited to the size of the
/// scan. With these options and the same seed, simulateCase simulates an angiogram of the same vessels.
TreeOptions treeOptionsForScan(const TreeOptions& tree, const CtaOptions& cta);

/// Simulates the CT scan of a generated tree in a body of fat, muscle and organs with spine, ribs and the scanner
/// table, including partial volume, blur and noise. The tree extends over about three quarters of the scan, close to
/// bone. Results are bitwise identical for the same seed.
SimulatedCta simulateCta(std::uint64_t seed, const TreeOptions& tree = {}, const CtaOptions& cta = {});

}   // namespace angiopose::core
