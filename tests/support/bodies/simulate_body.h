#pragma once

#include "core/imaging/volume.h"
#include "core/vessel/vessel_tree.h"

#include <cstdint>
#include <vector>

namespace angiopose::core {

/// Acquisition parameters of a simulated body scan, in HU.
struct BodyScanOptions {
    Eigen::Vector3d spacingMm = {0.5, 0.5, 0.6};
    double bloodHu = 400.0;   ///< enhancement of the arteries
    double noiseHu = 25.0;   ///< standard deviation
    double blurVoxels = 0.7;   ///< standard deviation of the point spread function
};

/// A scan with arteries that are hard to distinguish from adjacent structures.
struct BodyScan {
    Volume volume;   ///< axes parallel to the patient axes, LPS
    VesselTree arteries;   ///< arteries to be traced
    std::vector<Eigen::Vector3d> origins;   ///< a point near the origin of each artery, where a user would click
};

/// Coronary arteries (radius 0.7 to 2.1 mm) on a heart with opacified chambers, with aortic root, pulmonary trunk,
/// lungs and chest. The arteries originate at the wall of the root. Deterministic for a seed.
BodyScan simulateHeart(std::uint64_t seed, const BodyScanOptions& options = {});

/// Hepatic artery (radius 0.8 to 2.5 mm) with the less bright portal vein next to each of its branches, in an enhanced
/// liver; aorta, celiac trunk, spleen and kidneys.
BodyScan simulateLiver(std::uint64_t seed, const BodyScanOptions& options = {});

/// Carotid and vertebral arteries through the base of the skull, the circle of Willis with its loop and the cerebral
/// arteries (radius 0.6 to 2.3 mm), with less bright sinuses below the vault.
BodyScan simulateHead(std::uint64_t seed, const BodyScanOptions& options = {});

}   // namespace angiopose::core
