#include "core/tracing/volume/scan_lumen.h"

#include "core/messages/messages.h"
#include "core/support/parallel_for.h"
#include "core/tracing/volume/lumen/segment_lumen.h"
#include "core/tracing/volume/voxels/component_selection.h"

#include <algorithm>
#include <utility>

namespace angiopose::core {
namespace {

const LumenLevels hounsfieldBone{45.0, 400.0, 222.5, true};   ///< an opacification of 1.5 corresponds to 578 HU
constexpr double maxBloodOfHeadHu = 650.0;   ///< brighter homogeneous voxels may be skull or petrous bone
constexpr double maxLumenFraction = 0.06;   ///< maximum fraction of all voxels; brain or muscle occupies more
constexpr double maxFillOfBlood = 1.6;
constexpr double minWideRadiusMm = 5.0;   ///< minimum radius of an aorta or iliac artery
constexpr double minFillOfClear = 0.75;
constexpr double entryDistanceMm = 25.0;   ///< distance from the lower face, where thinner arteries enter
constexpr double minVeinRadiusMm = 1.2;   ///< thinner vessels may be cortical arteries
constexpr double maxAlongSkull = 0.1;   ///< maximum fraction of the traced length

class LumenFinder {
public:
    LumenFinder(const Volume& volume, const AxisOrder& order, const VesselTracingOptions& options,
                TracingProgress& progress)
        : volume_(volume), order_(order), options_(options), progress_(progress)
    {
    }

    Result<ScanLumen> find()
    {
        auto defaultLevels = findDefaultLevels();
        if (progress_.isStopped()) {
            return tracingCanceled();
        }
        if (defaultLevels) {
            const LumenLevels level = defaultLevels.value();
            auto seen = segment(level, result_.skull ? fineBlockMm : defaultBlockMm);
            if (!seen || level.isHu || options_.threshold || isPlausible()) {
                return seen ? selectArteries() : Result<ScanLumen>(seen.error());
            }
        } else if (options_.threshold || isInHounsfield(volume_, order_)) {
            return defaultLevels.error();
        }
        const auto brightest = findBrightestLevels(result_.scan(volume_), order_);
        if (!brightest) {
            return defaultLevels ? requestSeed(messages::scanNeedsSeed()) : Result<ScanLumen>(brightest.error());
        }
        if (const auto seen = segment(brightest.value(), fineBlockMm); !seen) {
            return seen.error();
        }
        return isCredible() ? selectArteries() : requestSeed(messages::scanNeedsSeed());
    }

private:
    Result<LumenLevels> findDefaultLevels()
    {
        progress_.enter("blood", 0.0, 0.05);
        auto level = findLumenLevels(volume_, order_, {.threshold = options_.threshold});
        if (options_.threshold) {
            return level;
        }
        const bool isHu = level ? level.value().isHu : isInHounsfield(volume_, order_);
        if (!isHu) {
            result_.corrected = correctBiasField(volume_, order_);
            if (result_.corrected) {
                level = findLumenLevels(result_.corrected->volume, order_);
                if (level && level.value().isHu) {   // amplified noise is not air
                    level = withoutHounsfield(level.value());
                }
            }
            return level;
        }
        const VoxelOpacification fill = voxelOpacification(volume_, order_, hounsfieldBone);
        result_.skull = findSkull(order_.geometry, fill, threadCount(options_.threads), progress_);
        if (result_.skull && level && level.value().blood > maxBloodOfHeadHu) {
            level = findLumenLevels(volume_, order_, {.maxBlood = maxBloodOfHeadHu});
        }
        return level;
    }

    static Result<LumenLevels> withoutHounsfield(LumenLevels level)
    {
        level.isHu = false;
        return level;
    }

    Status segment(const LumenLevels& level, double blockMm)
    {
        progress_.enter("vessels", 0.05, 0.7);
        result_.level = level;
        const Volume& scan = result_.scan(volume_);
        SegmentedLumen candidates = segmentLumen(scan, order_, level, threadCount(options_.threads), progress_);
        if (!progress_.advance(0.0)) {
            return tracingCanceled();
        }
        const auto set =
            std::ranges::count_if(candidates.clearLumen.voxels, [](std::uint8_t voxel) { return voxel != 0; });
        if (set == 0) {
            return noVesselsError(level);
        }
        lumenFraction_ = static_cast<double>(set) / static_cast<double>(candidates.clearLumen.voxels.size());
        isLikeCt_ = level.isHu || hasMoreBone();
        if (isLikeCt_ && !level.isHu && !options_.threshold) {
            result_.skull = findSkull(order_.geometry, voxelOpacification(scan, order_, result_.level),
                                      threadCount(options_.threads), progress_);
        }
        const VoxelOpacification fill = voxelOpacification(scan, order_, result_.level);
        result_.found =
            findGreatVessels(std::move(candidates), fill, threadCount(options_.threads), progress_, blockMm);
        if (!progress_.advance(0.0)) {
            return tracingCanceled();
        }
        return Done();
    }

    bool isCredible() const { return lumenFraction_ <= maxLumenFraction; }

    /// Returns whether the lumen level is certain, or plausible and confirmed by seeds in the vessels.
    bool isPlausible() const
    {
        const std::vector<GreatVessel>& greatVessels = result_.found.greatVessels;
        const bool isWide = !greatVessels.empty() &&
                            greatVessels.front().trunks.front().medianRadiusMm() >= minWideRadiusMm &&
                            isClear(greatVessels.front());
        return isCredible() && (isWide || isLikeCt_ || !options_.seedsInPatient.empty());
    }

    /// Returns whether voxels brighter than the lumen outnumber the lumen itself: bone, as in CT. In MR, the vessels
    /// are brightest, and the assumed lumen is fat or brain.
    bool hasMoreBone() const
    {
        const VoxelOpacification fill = voxelOpacification(result_.scan(volume_), order_, result_.level);
        const Eigen::Vector3i& size = order_.geometry.size;
        std::size_t bright = 0;
        std::size_t sampledCount = 0;
        for (int k = 0; k < size.z(); k += 2) {
            for (int j = 0; j < size.y(); j += 2) {
                for (int i = 0; i < size.x(); i += 2, ++sampledCount) {
                    bright += fill(i, j, k) > maxFillOfBlood ? 1 : 0;
                }
            }
        }
        return static_cast<double>(bright) >= lumenFraction_ * static_cast<double>(sampledCount);
    }

    Result<ScanLumen> requestSeed(const Message& question)
    {
        return options_.seedsInPatient.empty() ? Result<ScanLumen>(Error(question)) : std::move(result_);
    }

    /// Without seeds, keeps only definite arteries as starting points.
    Result<ScanLumen> selectArteries()
    {
        std::vector<GreatVessel>& greatVessels = result_.found.greatVessels;
        if (result_.skull) {
            result_.veins = sinusPoints(greatVessels, *result_.skull);
        }
        if (!options_.seedsInPatient.empty() || options_.threshold) {
            return std::move(result_);
        }
        if (result_.skull) {
            greatVessels = selectHeadArteries(std::move(greatVessels), *result_.skull, order_.geometry);
            return greatVessels.empty() ? requestSeed(messages::headNeedsSeed()) : std::move(result_);
        }
        if (!isLikeCt_) {
            std::erase_if(greatVessels, [this](const GreatVessel& vessel) { return !isClear(vessel); });
            return greatVessels.empty() ? requestSeed(messages::scanNeedsSeed()) : std::move(result_);
        }
        return std::move(result_);
    }

    /// Returns whether the vessel is as wide as an aorta or enters at the lower face of the scan.
    bool isClear(const GreatVessel& vessel) const
    {
        const Trunk& trunk = vessel.trunks.front();
        const double faceMm = order_.geometry.originInPatient.z();
        const bool entersBelow = std::ranges::any_of(vessel.trunks, [&](const Trunk& its) {
            return std::ranges::any_of(its.pointsInPatient, [&](const Eigen::Vector3d& point) {
                return point.z() <= faceMm + entryDistanceMm;
            });
        });
        return trunk.fill >= minFillOfClear && (trunk.medianRadiusMm() >= minWideRadiusMm || entersBelow);
    }

    const Volume& volume_;
    const AxisOrder& order_;
    const VesselTracingOptions& options_;
    TracingProgress& progress_;
    ScanLumen result_;
    double lumenFraction_ = 0.0;
    bool isLikeCt_ = true;   ///< bone is the brightest structure
};

}   // namespace

VoxelOpacification voxelOpacification(const Volume& volume, const AxisOrder& order, const LumenLevels& level)
{
    return [&volume, &order, &level](int i, int j, int k) {
        return (volume.value(order.stored(i, j, k)) - level.tissue) / level.contrast();
    };
}

Result<ScanLumen> findScanLumen(const Volume& volume, const AxisOrder& order, const VesselTracingOptions& options,
                                TracingProgress& progress)
{
    return LumenFinder(volume, order, options, progress).find();
}

bool runsAlongSkull(const VesselTree& tree, const Skull& skull)
{
    double lengthMm = 0.0;
    double adjacentMm = 0.0;
    for (const VesselBranch& branch : tree.branches) {
        for (std::size_t n = 1; n < branch.pointsInPatient.size(); ++n) {
            const double stepMm = (branch.pointsInPatient[n] - branch.pointsInPatient[n - 1]).norm();
            const bool isNextToBone = branch.radiusMm[n] >= minVeinRadiusMm &&
                                      skull.isNextToInnerTable(branch.pointsInPatient[n], branch.radiusMm[n]);
            lengthMm += stepMm;
            adjacentMm += isNextToBone ? stepMm : 0.0;
        }
    }
    return adjacentMm > maxAlongSkull * lengthMm;
}

}   // namespace angiopose::core
