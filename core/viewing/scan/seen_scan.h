#pragma once

#include "core/imaging/volume.h"
#include "core/vessel/vessel_tree.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace angiopose::core {

/// What a scan is made from that is to be looked through.
struct ScanToSee {
    std::shared_ptr<const Volume> scan;   ///< or null: the mask alone is seen
    std::shared_ptr<const VoxelMask> mask;   ///< the lumen (1), or labels by their places (1, 2, …); or null
    std::shared_ptr<const VesselTree> tree;   ///< says where vessels are where no mask does; or null
    std::optional<Eigen::AlignedBox3d> boxInPatient{};   ///< only what is within
    std::size_t mostVoxels = 8'000'000;   ///< the scan is reduced to so many
};

/// A scan, reduced, with what belongs to the vessels, ready to be looked through by `castScan`. Three bytes a voxel.
struct SeenScan {
    Volume volume;   ///< of a mask alone: `maskValue` inside, 0 outside
    std::vector<std::uint8_t> kinds;   ///< of each voxel: 0 the rest of the body, else the mask's value
    bool hasKinds = false;   ///< it is known where vessels are

    /// The least and the greatest value of blocks of voxels, as far as rays may look from inside: what is seen nowhere
    /// in a block is left out at once.
    struct Block {
        std::int16_t low = 0;
        std::int16_t high = 0;
        bool hasRest = false;
        bool hasVessels = false;
    };
    std::vector<Block> blocks;
    Eigen::Vector3i blockCount = Eigen::Vector3i::Zero();
};

inline constexpr int seenBlockSide = 8;
inline constexpr std::int16_t maskValue = 1000;

/// Nothing where there is nothing to see, or once `goesOn` says no.
std::optional<SeenScan> seenScan(const ScanToSee& wish, const std::function<bool()>& goesOn);

}   // namespace angiopose::core
