#include "core/tracing/volume/lumen/segment_lumen.h"

#include "core/imaging/interpolate_grid.h"
#include "core/support/parallel_for.h"
#include "core/tracing/volume/lumen/blooming_voxels.h"
#include "core/tracing/volume/lumen/bright_components.h"
#include "core/tracing/volume/lumen/mark_tubes.h"
#include "core/tracing/volume/lumen/stent_part.h"
#include "core/tracing/volume/stents/stent_width.h"
#include "core/tracing/volume/stents/stented_lumen.h"
#include "core/tracing/volume/voxels/voxel_components.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace angiopose::core {
namespace {

constexpr TubeBits bits;
constexpr std::uint8_t core = 4;   ///< homogeneous, with the intensity of the lumen
constexpr std::uint8_t tooBright = 8;
constexpr std::uint8_t calcification = 16;   ///< brighter than the lumen, in a small component
constexpr std::uint8_t metal = 32;   ///< brighter than the lumen, part of a stent around lumen
constexpr std::uint8_t blooming = 64;   ///< see `markBlooming`
constexpr std::uint8_t wallBits = tooBright | metal;

constexpr double minTubeFill = 0.25;   ///< minimum opacification of a voxel of a thin vessel
constexpr double minCoreFill = 0.55;
constexpr double maxFillOfLumen = 1.6;   ///< brighter voxels are bone, metal or unmixed contrast agent
constexpr double maxMetal = 6.0;   ///< cap in cross-sections; higher values add no information
constexpr double maxCoreDeviation = 0.18;   ///< maximum standard deviation within a core
constexpr double maxBrightMl = 0.1;   ///< volume limit of calcifications; larger bright components are bone or metal
constexpr double coreReachMm = 1.4;   ///< distance from a core to the wall; at least two voxels
constexpr double rimMm = 1.5;   ///< rim of bone and metal where blurring mimics lumen; at least one voxel
constexpr int maxStrutWidth = 2;   ///< voxels from the edge of a strut to its brightest line
constexpr double bloomingMm = 4.0;   ///< reach of streaks and blurring from bone and dense contrast agent
constexpr double cortexReachMm = 1.4;   ///< distance from marrow to cortical bone; at least two voxels
constexpr double maxBoneWall = 0.3;   ///< maximum fraction of a vessel's wall that borders bone
constexpr double minCoreShare = 0.2;   ///< minimum fraction of cores in a stented vessel; marrow has fewer

class Segmenter {
public:
    Segmenter(const Volume& volume, const AxisOrder& order, const LumenLevels& level, int threads)
        : volume_(volume),
          order_(order),
          level_(level),
          size_(order.geometry.size),
          threads_(threads),
          coreReach_(voxelsIn(coreReachMm, 2)),
          rim_(voxelsIn(rimMm, 1)),
          bloomingReach_(voxelsIn(bloomingMm, 2)),
          cortexReach_(voxelsIn(cortexReachMm, 2)),
          flags_(order.geometry)
    {
    }

    SegmentedLumen run(TracingProgress& progress)
    {
        markTooBright(progress);
        forEachSlice(progress, [&](int k) { markCores(k); });
        openThinStents(progress);
        markTubes(volume_, order_, level_, minTubeFill, flags_, bits, threads_, progress);
        markBlooming(flags_, {tooBright, core | metal, blooming}, opacification(), minTubeFill, bloomingReach_,
                     progress);
        SegmentedLumen lumen{VoxelMask(order_.geometry), {}};
        forEachSlice(progress, [&](int k) { selectVoxels(lumen.clearLumen, k); });
        if (progress.advance(0.0)) {
            removeMarrow(lumen.clearLumen, progress);
        }
        if (progress.advance(0.0)) {
            lumen.voxelsBesideStruts = growLumenBesideStruts(lumen.clearLumen, struts(), opacification(),
                                                             rim_.maxCoeff() + maxStrutWidth, progress);
        }
        return lumen;
    }

private:
    /// Converts a length to a number of voxels along each axis, at least `least`.
    Eigen::Vector3i voxelsIn(double mm, int least) const
    {
        return (mm / order_.geometry.spacingMm.array()).round().cast<int>().max(least);
    }

    template <class Visit>
    void forEachSlice(TracingProgress& progress, const Visit& visit)
    {
        parallelFor(
            static_cast<std::size_t>(size_.z()), threads_, [&](std::size_t k) { visit(static_cast<int>(k)); },
            [&](double) { return progress.advance(0.0); });
    }

    template <class Visit>
    void forEachVoxel(VoxelMask& mask, int k, const Visit& visit)
    {
        for (int j = 0; j < size_.y(); ++j) {
            for (int i = 0; i < size_.x(); ++i) {
                visit(i, j, mask.at(i, j, k));
            }
        }
    }

    double fillAt(int i, int j, int k) const
    {
        return (volume_.value(order_.stored(i, j, k)) - level_.tissue) / level_.contrast();
    }

    VoxelOpacification opacification() const
    {
        return [this](int i, int j, int k) { return fillAt(i, j, k); };
    }

    /// Marks voxels brighter than the lumen: large components are bone and metal, small ones calcified plaque in a
    /// wall.
    void markTooBright(TracingProgress& progress)
    {
        forEachSlice(progress, [&](int k) {
            forEachVoxel(flags_, k,
                         [&](int i, int j, std::uint8_t& flag) { flag = fillAt(i, j, k) > maxFillOfLumen ? 1 : 0; });
        });
        if (progress.isStopped()) {
            return;
        }
        labelBrightComponents(flags_, maxBrightMl, {tooBright, calcification, metal}, [&](const VoxelComponent& piece) {
            VoxelComponent stent = findStentPart(piece, order_.geometry, level_, opacification());
            if (!stent.empty()) {
                stents_.push_back(stent);
            }
            return stent;
        });
    }

    /// Turns the struts of thin stents into lumen: in a thin vessel they blur together and are the only visible part.
    /// In a wide vessel, the struts form the wall.
    void openThinStents(TracingProgress& progress)
    {
        std::vector<VoxelComponent> wide;
        for (VoxelComponent& stent : stents_) {
            if (isWideStent(stent, flags_, core, threads_, progress)) {
                wide.push_back(std::move(stent));
                continue;
            }
            for (const std::uint32_t voxel : stent) {
                flags_.voxels[voxel] = core;
            }
        }
        stents_ = std::move(wide);
    }

    StentStruts struts() const
    {
        return {stents_, [this](int i, int j, int k) {
                    return isNear(i, j, k, rim_, metal) && !isNear(i, j, k, rim_, tooBright);
                }};
    }

    void markCores(int k)
    {
        forEachVoxel(flags_, k, [&](int i, int j, std::uint8_t& flag) {
            if (flag == 0 && isHomogeneous(i, j, k)) {
                flag = core;
            }
        });
    }

    /// Returns whether the voxel and six samples at some distance on all sides have the intensity of the lumen and vary
    /// little; edge values are repeated beyond the boundary.
    bool isHomogeneous(int i, int j, int k) const
    {
        const int x = coreReach_.x();
        const int y = coreReach_.y();
        const int z = coreReach_.z();
        const std::array<std::array<int, 3>, 7> steps{
            {{0, 0, 0}, {x, 0, 0}, {-x, 0, 0}, {0, y, 0}, {0, -y, 0}, {0, 0, z}, {0, 0, -z}}};
        double sum = 0.0;
        double squares = 0.0;
        for (const auto& step : steps) {
            const double opacification =
                fillAt(std::clamp(i + step[0], 0, size_.x() - 1), std::clamp(j + step[1], 0, size_.y() - 1),
                       std::clamp(k + step[2], 0, size_.z() - 1));
            if (opacification < minCoreFill || opacification > maxFillOfLumen) {
                return false;
            }
            sum += opacification;
            squares += opacification * opacification;
        }
        const double mean = sum / steps.size();
        return squares / steps.size() - mean * mean < maxCoreDeviation * maxCoreDeviation;
    }

    bool isNear(int i, int j, int k, const Eigen::Vector3i& reach, std::uint8_t flagMask) const
    {
        for (int z = std::max(0, k - reach.z()); z <= std::min(size_.z() - 1, k + reach.z()); ++z) {
            for (int y = std::max(0, j - reach.y()); y <= std::min(size_.y() - 1, j + reach.y()); ++y) {
                for (int x = std::max(0, i - reach.x()); x <= std::min(size_.x() - 1, i + reach.x()); ++x) {
                    if ((flags_.at(x, y, z) & flagMask) != 0) {
                        return true;
                    }
                }
            }
        }
        return false;
    }

    /// Selects cores, bright voxels around them, and tubes with adjacent bright voxels; excludes the rim of bone and
    /// metal, where blurring mimics lumen.
    void selectVoxels(VoxelMask& lumen, int k) const
    {
        for (int j = 0; j < size_.y(); ++j) {
            for (int i = 0; i < size_.x(); ++i) {
                const std::uint8_t flag = flags_.at(i, j, k);
                if (flag == 0 || (flag & blooming) != 0 || isNear(i, j, k, rim_, wallBits)) {
                    continue;
                }
                const bool isCore = (flag & core) != 0;
                if (isCore || (flag & bits.tube) != 0 || isNear(i, j, k, Eigen::Vector3i::Ones(), bits.tube) ||
                    isNear(i, j, k, coreReach_, core)) {
                    lumen.at(i, j, k) = isCore ? 2 : 1;
                }
            }
        }
    }

    void removeMarrow(VoxelMask& lumen, TracingProgress& progress) const
    {
        for (const VoxelComponent& piece : connectedComponents(lumen)) {
            if (!progress.advance(0.0)) {
                return;
            }
            if (isMarrow(piece, lumen)) {
                for (const std::uint32_t voxel : piece) {
                    lumen.voxels[voxel] = 0;
                }
            }
        }
    }

    /// Returns whether a component is marrow, which can be as bright as the lumen but is inhomogeneous and surrounded
    /// by cortical bone.
    bool isMarrow(const VoxelComponent& piece, const VoxelMask& lumen) const
    {
        std::size_t cores = 0;
        std::size_t wall = 0;
        std::size_t boneWall = 0;
        for (const std::uint32_t voxel : piece) {
            const Eigen::Vector3i at = flags_.geometry.voxelAt(voxel);
            cores += lumen.voxels[voxel] > 1 ? 1 : 0;
            if (isWall(lumen, at)) {
                ++wall;
                boneWall += isNear(at.x(), at.y(), at.z(), cortexReach_, tooBright) ? 1 : 0;
            }
        }
        return static_cast<double>(boneWall) > maxBoneWall * static_cast<double>(wall) &&
               static_cast<double>(cores) < minCoreShare * static_cast<double>(piece.size());
    }

    static bool isWall(const VoxelMask& lumen, const Eigen::Vector3i& voxel)
    {
        for (int axis = 0; axis < 3; ++axis) {
            for (const int step : {-1, 1}) {
                Eigen::Vector3i next = voxel;
                next[axis] += step;
                if (lumen.geometry.contains(next) && lumen.at(next.x(), next.y(), next.z()) == 0) {
                    return true;
                }
            }
        }
        return false;
    }

    const Volume& volume_;
    const AxisOrder& order_;
    const LumenLevels& level_;
    Eigen::Vector3i size_;
    int threads_;
    Eigen::Vector3i coreReach_;   ///< in voxels along each axis, like the reaches below
    Eigen::Vector3i rim_;
    Eigen::Vector3i bloomingReach_;
    Eigen::Vector3i cortexReach_;
    std::vector<VoxelComponent> stents_;   ///< all stents; later only those of wide vessels
    VoxelMask flags_;
};

}   // namespace

SegmentedLumen segmentLumen(const Volume& volume, const AxisOrder& order, const LumenLevels& level, int threads,
                            TracingProgress& progress)
{
    return Segmenter(volume, order, level, threads).run(progress);
}

PointOpacification opacificationIn(const Volume& volume, const AxisOrder& order, const LumenLevels& level,
                                   const VoxelMask& lumen)
{
    return [&volume, order, level, &lumen](const Eigen::Vector3d& pointMm) {
        return interpolateTrilinear(order.geometry, pointMm, [&](const Eigen::Vector3i& at) {
            const double opacification =
                (volume.value(order.stored(at.x(), at.y(), at.z())) - level.tissue) / level.contrast();
            const std::uint8_t kind = lumen.at(at.x(), at.y(), at.z());
            return kind == 2                           ? 1.0
                   : opacification >= 0.5 && kind == 0 ? 0.0
                                                       : std::clamp(opacification, -1.0, maxMetal);
        });
    };
}

}   // namespace angiopose::core
