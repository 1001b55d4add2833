#pragma once

#include "core/imaging/volume.h"
#include "core/vessel/vessel_tree.h"

#include <cstdint>
#include <vector>

namespace angiopose::core {

/// How a scan of a body's part was taken, HU.
struct BodyScanOptions {
    Eigen::Vector3d spacingMm = {0.5, 0.5, 0.6};
    double bloodHu = 400.0;   ///< of the arteries
    double noiseHu = 25.0;   ///< standard deviation
    double blurVoxels = 0.7;   ///< standard deviation of the point spread
};

/// A scan with arteries that are hard to tell from what is beside them.
struct BodyScan {
    Volume volume;   ///< axes along the patient's, LPS
    VesselTree arteries;   ///< those that are asked for
    std::vector<Eigen::Vector3d> origins;   ///< a place near the beginning of each, where one would click
};

/// Coronary arteries (radius 0.7 to 2.1 mm) on a heart whose chambers are filled too, with aortic root, pulmonary
/// trunk, lungs and chest. The arteries begin at the wall of the root. Same seed, same bits.
BodyScan simulateHeart(std::uint64_t seed, const BodyScanOptions& options = {});

/// Hepatic artery (radius 0.8 to 2.5 mm) with the portal vein beside each of its branches, less bright, in an enhanced
/// liver; aorta, coeliac trunk, spleen and kidneys.
BodyScan simulateLiver(std::uint64_t seed, const BodyScanOptions& options = {});

/// Carotid and vertebral arteries through the base of the skull, the circle of Willis with its loop and the cerebral
/// arteries (radius 0.6 to 2.3 mm); sinuses, less bright, below the vault.
BodyScan simulateHead(std::uint64_t seed, const BodyScanOptions& options = {});

}   // namespace angiopose::core
