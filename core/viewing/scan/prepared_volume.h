#pragma once

#include "core/imaging/volume.h"
#include "core/vessel/vessel_tree.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace angiopose::core {

/// What a scan is made from that is to be looked through.
struct VolumeToPrepare {
    std::shared_ptr<const Volume> scan;   ///< or null: the mask alone is seen
    std::shared_ptr<const VoxelMask> mask;   ///< the lumen (1), or labels by their places (1, 2, …); or null
    std::shared_ptr<const VesselTree> tree;   ///< says where vessels are where no mask does; or null
    std::optional<Eigen::AlignedBox3d> boxInPatient{};   ///< only what is within
    std::size_t maxVoxels = 8'000'000;   ///< the scan is reduced to so many
};

/// A scan, reduced, with what belongs to the vessels, ready to be looked through by `castScan`. Three bytes a voxel.
struct PreparedVolume {
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

/// Nothing where there is nothing to see, or once `shouldContinue` says no.
std::optional<PreparedVolume> preparedVolume(const VolumeToPrepare& request,
                                             const std::function<bool()>& shouldContinue);

/// sRGB, 0…1.
using Rgb = std::array<float, 3>;

/// How strongly values hide what is behind them: nothing below `from`, `perMm` from `full` on, between them linearly.
struct Opacity {
    double from = 0.0;   ///< in the scan's values (HU)
    double full = 1.0;
    double perMm = 0.0;

    double at(double value) const;
    bool operator==(const Opacity&) const = default;
};

/// How a scan is seen.
struct ScanLook {
    Opacity vessels;   ///< of what belongs to vessels
    Opacity rest;   ///< of all else
    double brightFrom = 0.0;   ///< all else goes from `soft` at its beginning to `bone` here
    Rgb soft{};
    Rgb bone{};
    std::vector<Rgb> kinds;   ///< of vessels, or of labels 1, 2, …; the last of all beyond

    bool operator==(const ScanLook&) const = default;
};

enum class ScanPreset { Vessels, VesselsAndBone };

/// What a preset depends on besides the scan.
struct ScanRequest {
    ScanPreset preset = ScanPreset::Vessels;
    double strength = 0.5;   ///< 0…1, of all opacities together
    Rgb soft{};
    Rgb bone{};
    std::vector<Rgb> kinds;

    bool operator==(const ScanRequest&) const = default;
};

/// What the values of a scan say about vessels, to be looked at: no more than that.
struct SeenLevels {
    double tissue = 0.0;
    double wall = 200.0;   ///< half way from tissue to blood
    double blood = 400.0;
    bool isHu = false;
};

/// The levels that tracing would find, or the threshold it was given; else, of MR and of what has no units, from the
/// scan's own histogram: a vessel is brighter than nearly all.
SeenLevels seenLevels(const Volume& volume, std::optional<double> threshold);

/// `hasKinds`: it is known where vessels are, so that all else can be told from them.
ScanLook lookOf(const SeenLevels& levels, const ScanRequest& request, bool hasKinds);

/// Of a mask without a scan.
ScanLook lookOfMask(const ScanRequest& request);

}   // namespace angiopose::core
