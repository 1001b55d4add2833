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

/// Input from which a scan is prepared for volume rendering.
struct VolumePreparation {
    std::shared_ptr<const Volume> scan;   ///< null to show only the mask
    std::shared_ptr<const VoxelMask> mask;   ///< lumen (1), or labels by their index (1, 2, …); may be null
    std::shared_ptr<const VesselTree> tree;   ///< locates the vessels if there is no mask; may be null
    std::optional<Eigen::AlignedBox3d> boxInPatient{};   ///< box to which the scan is restricted
    std::size_t maxVoxels = 8'000'000;   ///< maximum size to which the scan is reduced
};

/// A reduced scan with its vessel voxels marked, ready for `renderScan`. Uses three bytes per voxel.
struct PreparedVolume {
    Volume volume;   ///< without a scan: `maskValue` inside the mask, 0 outside
    std::vector<std::uint8_t> kinds;   ///< one per voxel: the value of the mask, or 0 for the rest of the body
    bool hasVesselLabels = false;   ///< whether the location of the vessels is known

    /// Minimum and maximum value in a block of voxels, including the voxels used for interpolation; rays skip blocks in
    /// which nothing is visible.
    struct Block {
        std::int16_t low = 0;
        std::int16_t high = 0;
        bool hasOtherVoxels = false;
        bool hasVessels = false;
    };
    std::vector<Block> blocks;
    Eigen::Vector3i blockCount = Eigen::Vector3i::Zero();
};

inline constexpr int blockSideVoxels = 8;
inline constexpr std::int16_t maskValue = 1000;

/// Prepares the scan. Returns nullopt if there is nothing to show or if `shouldContinue` returns false.
std::optional<PreparedVolume> prepareVolume(const VolumePreparation& request,
                                            const std::function<bool()>& shouldContinue);

/// sRGB color, components 0…1.
using Rgb = std::array<float, 3>;

/// Opacity ramp: zero up to `from`, `perMm` above `full`, linear in between.
struct Opacity {
    double from = 0.0;   ///< in units of the scan (HU)
    double full = 1.0;
    double perMm = 0.0;

    double at(double value) const;
    bool operator==(const Opacity&) const = default;
};

/// Appearance of a rendered scan.
struct ScanAppearance {
    Opacity vessels;   ///< opacity of vessel voxels
    Opacity rest;   ///< opacity of all other voxels
    double brightFrom = 0.0;   ///< value at which other voxels reach `bone`; they start with `soft` at `rest.from`
    Rgb softTissueColor{};
    Rgb boneColor{};
    std::vector<Rgb> kinds;   ///< colors of the vessels, or of labels 1, 2, …; further labels use the last color

    bool operator==(const ScanAppearance&) const = default;
};

enum class ScanPreset { Vessels, VesselsAndBone };

/// Parameters of the appearance that do not depend on the scan.
struct AppearanceOptions {
    ScanPreset preset = ScanPreset::Vessels;
    double strength = 0.5;   ///< 0…1; scales all opacities
    Rgb softTissueColor{};
    Rgb boneColor{};
    std::vector<Rgb> kinds;

    bool operator==(const AppearanceOptions&) const = default;
};

/// Estimated intensities of tissue and contrast-enhanced lumen in a scan, for display only.
struct IntensityLevels {
    double tissue = 0.0;
    double wall = 200.0;   ///< halfway between tissue and lumen
    double blood = 400.0;
    bool isHu = false;
};

/// Returns the levels that tracing would find, or the given threshold; otherwise (MR, scans without units) levels from
/// the scan's own histogram, in which vessels are brighter than nearly all other voxels.
IntensityLevels estimateLevels(const Volume& volume, std::optional<double> threshold);

/// Returns the appearance for these levels. `hasVesselLabels` states whether vessel voxels are known and shown
/// separately.
ScanAppearance appearanceFor(const IntensityLevels& levels, const AppearanceOptions& request, bool hasVesselLabels);

/// Returns the appearance of a mask without a scan.
ScanAppearance maskAppearance(const AppearanceOptions& request);

}   // namespace angiopose::core
