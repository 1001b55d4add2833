#include "core/viewing/scan/prepared_volume.h"

#include "core/imaging/mark_ball.h"
#include "core/imaging/reduce_volume.h"
#include "core/support/parallel_for.h"
#include "core/support/quantile.h"
#include "core/tracing/volume/lumen/lumen_levels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace angiopose::core {
namespace {

constexpr double wallShare = 1.3;   // factor on the radius: a vessel's blurred wall extends slightly beyond it
constexpr double wallMm = 1.5;
constexpr double unknownRadiusMm = 1.5;

/// Converts the mask to values for rendering.
Volume valuesOf(const VoxelMask& mask)
{
    Volume values(mask.geometry);
    std::ranges::transform(mask.voxels, values.voxels.begin(),
                           [](std::uint8_t kind) { return kind != 0 ? maskValue : std::int16_t{0}; });
    return values;
}

/// Averages with the neighbors along each axis in turn, which turns the steps of a mask into slopes with a gradient.
void smooth(Volume& values)
{
    const Eigen::Vector3i& size = values.geometry.size;
    const std::array<std::size_t, 3> strides{1, values.geometry.index(0, 1, 0), values.geometry.index(0, 0, 1)};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::vector<std::int16_t> before = values.voxels;
        for (std::size_t i = 0; i < before.size(); ++i) {
            const int at = values.geometry.voxelAt(i)[static_cast<int>(axis)];
            const std::size_t low = at > 0 ? i - strides[axis] : i;
            const std::size_t high = at + 1 < size[static_cast<int>(axis)] ? i + strides[axis] : i;
            values.voxels[i] = static_cast<std::int16_t>((before[low] + 2 * before[i] + before[high]) / 4);
        }
    }
}

/// Copies the values of the mask to the nearest voxels of the downsampled scan; the grids may differ.
void markMask(const VoxelMask& mask, const VolumeGeometry& grid, std::vector<std::uint8_t>& kinds)
{
    const Eigen::Affine3d gridFromMask = grid.patientFromVoxel().inverse() * mask.geometry.patientFromVoxel();
    const Eigen::Vector3d step = gridFromMask.linear().col(0);
    const Eigen::Vector3i& size = mask.geometry.size;
    for (int k = 0; k < size.z(); ++k) {
        for (int j = 0; j < size.y(); ++j) {
            const Eigen::Vector3d first = gridFromMask * Eigen::Vector3d(0.0, j, k);
            const std::uint8_t* row = &mask.at(0, j, k);
            for (int i = 0; i < size.x(); ++i) {
                if (row[i] == 0) {
                    continue;
                }
                const Eigen::Vector3i at = (first + i * step).array().round().cast<int>();
                if (grid.contains(at)) {
                    kinds[grid.index(at.x(), at.y(), at.z())] = row[i];
                }
            }
        }
    }
}

void markTree(const VesselTree& tree, const VolumeGeometry& grid, std::vector<std::uint8_t>& kinds)
{
    VoxelMask mask(grid);
    for (const VesselBranch& branch : tree.branches) {
        for (std::size_t i = 0; i < branch.pointsInPatient.size(); ++i) {
            const double radiusMm = branch.radiusMm.empty() ? unknownRadiusMm : branch.radiusMm[i];
            markBall(branch.pointsInPatient[i], wallShare * radiusMm + wallMm, mask);
        }
    }
    kinds = std::move(mask.voxels);
}

/// Extends the vessels to adjacent voxels, which contain the blurred vessel walls.
void widen(const VolumeGeometry& grid, std::vector<std::uint8_t>& kinds)
{
    const std::array<std::size_t, 3> strides{1, grid.index(0, 1, 0), grid.index(0, 0, 1)};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::vector<std::uint8_t> before = kinds;
        const std::size_t stride = strides[axis];
        for (std::size_t i = stride; i + stride < before.size(); ++i) {
            if (before[i] == 0) {
                kinds[i] = std::max(before[i - stride], before[i + stride]);
            }
        }
    }
}

PreparedVolume::Block blockAt(const PreparedVolume& scan, const Eigen::Vector3i& first)
{
    const VolumeGeometry& grid = scan.volume.geometry;
    const Eigen::Vector3i last =
        (first.array() + blockSideVoxels).min(grid.size.array() - 1);   // includes one more voxel, for interpolation
    PreparedVolume::Block block;
    block.low = block.high = scan.volume.at(first.x(), first.y(), first.z());
    for (int k = first.z(); k <= last.z(); ++k) {
        for (int j = first.y(); j <= last.y(); ++j) {
            const std::size_t row = grid.index(first.x(), j, k);
            for (std::size_t i = row; i <= row + static_cast<std::size_t>(last.x() - first.x()); ++i) {
                block.low = std::min(block.low, scan.volume.voxels[i]);
                block.high = std::max(block.high, scan.volume.voxels[i]);
                (scan.kinds[i] != 0 ? block.hasVessels : block.hasOtherVoxels) = true;
            }
        }
    }
    return block;
}

void addBlocks(PreparedVolume& scan)
{
    scan.blockCount = (scan.volume.geometry.size.array() + blockSideVoxels - 1) / blockSideVoxels;
    scan.blocks.resize(static_cast<std::size_t>(scan.blockCount.prod()));
    parallelFor(
        static_cast<std::size_t>(scan.blockCount.z()), threadCount(0),
        [&scan](std::size_t k) {
            auto at = k * static_cast<std::size_t>(scan.blockCount.x() * scan.blockCount.y());
            for (int j = 0; j < scan.blockCount.y(); ++j) {
                for (int i = 0; i < scan.blockCount.x(); ++i) {
                    scan.blocks[at++] = blockAt(scan, blockSideVoxels * Eigen::Vector3i(i, j, static_cast<int>(k)));
                }
            }
        },
        [](double) { return true; });
}

constexpr std::size_t maxSampledVoxels = 60000;
constexpr double vesselPerMm = 1.2;   // a wall hides everything behind it within a few mm
constexpr double bonePerMm = 0.45;
constexpr double tissuePerMm = 0.02;
constexpr double brightQuantile = 0.985;   // quantile above which voxels count as vessels if nothing else is known
constexpr double brightestQuantile = 0.998;
constexpr double minStrengthFactor = 0.04;   // factor on all opacities at strength 0

double strengthFactor(double strength)
{
    return minStrengthFactor * std::pow(4.0 / minStrengthFactor, std::clamp(strength, 0.0, 1.0));
}

IntensityLevels levelsFromHistogram(const Volume& volume)
{
    std::vector<double> values;
    const std::size_t step = std::max<std::size_t>(1, volume.voxels.size() / maxSampledVoxels) | 1U;
    for (std::size_t i = 0; i < volume.voxels.size(); i += step) {
        values.push_back(volume.value(i));
    }
    if (values.empty()) {
        return {};
    }
    IntensityLevels levels;
    levels.tissue = quantile(values, 0.5);
    levels.wall = quantile(values, brightQuantile);
    levels.blood = std::max(quantile(values, brightestQuantile), levels.wall + 1e-3);
    return levels;
}

}   // namespace

std::optional<PreparedVolume> prepareVolume(const VolumePreparation& request,
                                            const std::function<bool()>& shouldContinue)
{
    if (!request.scan && !request.mask) {
        return std::nullopt;
    }
    const Volume alone = request.scan ? Volume() : valuesOf(*request.mask);
    const Volume& values = request.scan ? *request.scan : alone;
    auto volume =
        downsample(values, voxelRangeIn(values.geometry, request.boxInPatient), request.maxVoxels, shouldContinue);
    if (!volume) {
        return std::nullopt;
    }
    PreparedVolume scan;
    scan.volume = std::move(*volume);
    const VolumeGeometry& grid = scan.volume.geometry;
    scan.kinds.assign(grid.voxelCount(), 0);
    scan.hasVesselLabels = request.mask || (request.tree && !request.tree->branches.empty());
    if (request.mask) {
        markMask(*request.mask, grid, scan.kinds);
        widen(grid, scan.kinds);
    } else if (scan.hasVesselLabels) {
        markTree(*request.tree, grid, scan.kinds);
    }
    if (!request.scan) {
        smooth(scan.volume);
    }
    addBlocks(scan);
    return shouldContinue() ? std::optional(std::move(scan)) : std::nullopt;
}

double Opacity::at(double value) const
{
    return value < from ? 0.0 : perMm * std::clamp((value - from) / std::max(full - from, 1e-9), 0.0, 1.0);
}

IntensityLevels estimateLevels(const Volume& volume, std::optional<double> threshold)
{
    if (const auto found = findLumenLevels(volume, patientAxisOrder(volume.geometry), {.threshold = threshold})) {
        const LumenLevels& level = found.value();
        return {level.tissue, level.threshold, level.blood, level.isHu};
    }
    IntensityLevels levels = levelsFromHistogram(volume);
    if (threshold) {
        levels.wall = *threshold;
        levels.blood = std::max(levels.blood, *threshold + 1.0);
    }
    return levels;
}

ScanAppearance appearanceFor(const IntensityLevels& levels, const AppearanceOptions& request, bool hasVesselLabels)
{
    const double factor = strengthFactor(request.strength);
    const double contrast = std::max(levels.blood - levels.wall, 1e-3);
    ScanAppearance appearance;
    appearance.softTissueColor = request.softTissueColor;
    appearance.boneColor = request.boneColor;
    appearance.kinds = request.kinds;
    appearance.brightFrom = levels.blood + contrast;
    const double below = 0.25 * std::min(contrast, std::max(levels.wall - levels.tissue, 0.0));
    appearance.vessels = {levels.wall - below, levels.wall + 0.5 * contrast, vesselPerMm * factor};
    if (request.preset == ScanPreset::VesselsAndBone) {
        appearance.rest = levels.isHu ? Opacity{levels.wall, levels.blood, bonePerMm * factor}
                                      : Opacity{levels.tissue, levels.wall, tissuePerMm * factor};
    } else if (!hasVesselLabels) {   // shows everything as bright as the contrast-enhanced lumen
        appearance.rest = appearance.vessels;
        appearance.softTissueColor = request.kinds.empty() ? request.softTissueColor : request.kinds.front();
    }
    return appearance;
}

ScanAppearance maskAppearance(const AppearanceOptions& request)
{
    ScanAppearance appearance;
    appearance.kinds = request.kinds;
    appearance.vessels = {0.3 * maskValue, 0.6 * maskValue, vesselPerMm * strengthFactor(request.strength)};
    return appearance;
}

}   // namespace angiopose::core
