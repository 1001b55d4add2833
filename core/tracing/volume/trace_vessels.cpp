#include "core/tracing/volume/trace_vessels.h"

#include "core/messages/messages.h"
#include "core/support/parallel_for.h"
#include "core/support/quantile.h"
#include "core/tracing/tree/lumen_tree.h"
#include "core/tracing/tree/skeleton_coverage.h"
#include "core/tracing/volume/chosen/adjacent_lumen.h"
#include "core/tracing/volume/chosen/fill_cavities.h"
#include "core/tracing/volume/chosen/selected_lumen.h"
#include "core/tracing/volume/component_report.h"
#include "core/tracing/volume/lumen/lumen_levels.h"
#include "core/tracing/volume/lumen/segment_lumen.h"
#include "core/tracing/volume/path/trace_tubes.h"
#include "core/tracing/volume/scan_lumen.h"
#include "core/tracing/volume/tracing_warnings.h"
#include "core/tracing/volume/voxels/axis_order.h"
#include "core/tracing/volume/voxels/tracing_progress.h"

#include <algorithm>
#include <limits>
#include <set>
#include <utility>

namespace angiopose::core {
namespace {

constexpr int holeRounds = 4;
constexpr double minEvaluatedRadius = 1.5;   ///< in voxels; blurring dims the center of thinner vessels
constexpr double minAxisFill = 0.65;   ///< minimum median opacification of the branch centerlines
constexpr double minAlongsideMm = 80.0;   ///< minimum length beside a great vessel; pulmonary arteries reach under half
constexpr double minCoverage = 0.98;   ///< minimum covered fraction of a mask's skeleton; below, a warning is issued
constexpr double minHoleFill = 0.4;   ///< minimum mean opacification around a voxel darkened by noise

/// Returns the mask of the set voxels, in patient axis order.
template <class Grid, class IsSet>
VoxelMask maskOf(const Grid& grid, const IsSet& isSet)
{
    const AxisOrder order = patientAxisOrder(grid.geometry);
    VoxelMask whole(order.geometry);
    std::size_t voxel = 0;
    for (int k = 0; k < order.geometry.size.z(); ++k) {
        for (int j = 0; j < order.geometry.size.y(); ++j) {
            for (int i = 0; i < order.geometry.size.x(); ++i, ++voxel) {
                whole.voxels[voxel] = isSet(grid.voxels[order.stored(i, j, k)]) ? 1 : 0;
            }
        }
    }
    return whole;
}

/// Restores the axis order in which the input is stored.
VoxelMask toStoredOrder(const VoxelMask& part, const VoxelBox& box, const VolumeGeometry& stored)
{
    VoxelMask whole(stored);
    const AxisOrder order = crop(patientAxisOrder(stored), box);
    std::size_t voxel = 0;
    for (int k = 0; k < part.geometry.size.z(); ++k) {
        for (int j = 0; j < part.geometry.size.y(); ++j) {
            for (int i = 0; i < part.geometry.size.x(); ++i, ++voxel) {
                whole.voxels[order.stored(i, j, k)] = part.voxels[voxel] != 0 ? 1 : 0;
            }
        }
    }
    return whole;
}

std::optional<Message> problemWith(const VolumeGeometry& geometry, std::size_t voxels)
{
    if (voxels == 0 || geometry.voxelCount() != voxels) {
        return messages::volumeEmpty();
    }
    if (voxels > std::numeric_limits<std::uint32_t>::max()) {
        return messages::volumeTooLarge();
    }
    if (!(geometry.spacingMm.minCoeff() > 0.0) || !geometry.spacingMm.allFinite()) {
        return messages::volumeWithoutSpacing();
    }
    return {};
}

std::optional<Message> problemWith(const VesselTracingOptions& options)
{
    const bool hasSeeds = !options.seedsInPatient.empty();
    return options.avoidInPatient.empty() || hasSeeds ? std::nullopt
                                                      : std::optional<Message>(messages::avoidWithoutSeed());
}

/// Returns the options for a mask: all its components are vessels, unless the options select some.
VesselTracingOptions optionsForMask(VesselTracingOptions options)
{
    options.pieces = !options.seedsInPatient.empty()           ? TracedPieces::Usual
                     : options.pieces == TracedPieces::Largest ? TracedPieces::Largest
                                                               : TracedPieces::All;
    return options;
}

/// Returns the options for a scan: only components of great vessels are traced.
VesselTracingOptions optionsForScan(VesselTracingOptions options, const std::vector<GreatVessel>& greatVessels)
{
    if (greatVessels.empty() || !options.seedsInPatient.empty()) {
        options.pieces = TracedPieces::Usual;
    }
    return options;
}

/// Tree of a lumen, with the skeleton from which it was derived.
struct TreeWithSkeleton {
    TracedVessels vessels;
    std::vector<std::size_t> skeleton;   ///< voxels of the selected lumen
};

Result<TreeWithSkeleton> buildTree(const SelectedLumen& chosen, const PointOpacification& opacification,
                                   const VolumeGeometry& stored, const VesselTracingOptions& options,
                                   TracingProgress& progress)
{
    VesselTracingOptions chosenOptions = options;
    chosenOptions.seedsInPatient = chosen.startPointsInPatient;
    LumenTree found = traceLumenTree(chosen.lumen, opacification, chosenOptions, progress);
    if (progress.isStopped()) {
        return tracingCanceled();
    }
    TracedVessels traced;
    traced.tree = std::move(found.tree);
    traced.lumen = toStoredOrder(chosen.lumen, chosen.box, stored);
    traced.threshold = 0.5;
    traced.warnings = chosen.warnings;
    traced.pieces = listComponents(chosen.lumen, traced.tree, chosen.excluded, progress);
    const Messages componentMessages = componentWarnings(traced.pieces, !options.seedsInPatient.empty());
    traced.warnings.insert(traced.warnings.end(), componentMessages.begin(), componentMessages.end());
    if (progress.isStopped()) {
        return tracingCanceled();
    }
    if (found.closedGaps.count > 0) {
        traced.warnings.push_back(gapWarning(found.closedGaps));
    }
    if (found.loops.opened > 0) {
        traced.warnings.push_back(loopWarning(found.loops.opened));
    }
    if (found.loops.kept > 0) {
        traced.warnings.push_back(messages::loopsKept(found.loops.kept));
    }
    if (found.dimSubtrees > 0) {
        traced.warnings.push_back(dimSubtreeWarning(found.dimSubtrees));
    }
    return TreeWithSkeleton{std::move(traced), std::move(found.skeleton)};
}

/// Accepts holes caused by noise, which darkens single voxels; the wall between two touching vessels is a dark sheet.
HoleFilter noiseHoleFilter(const VoxelOpacification& opacification)
{
    return [&opacification](int i, int j, int k) {   // never called at the boundary
        const double sum = opacification(i, j, k) + opacification(i - 1, j, k) + opacification(i + 1, j, k) +
                           opacification(i, j - 1, k) + opacification(i, j + 1, k) + opacification(i, j, k - 1) +
                           opacification(i, j, k + 1);
        return sum > 7.0 * minHoleFill;
    };
}

/// Closes holes in `lumen` caused by noise or calcified plaque; stops on request.
void closeHoles(VoxelMask& lumen, const VoxelOpacification& opacification, TracingProgress& progress)
{
    const HoleFilter isHole = noiseHoleFilter(opacification);
    for (int round = 0; round < holeRounds && progress.advance(selectedProgress); ++round) {
        fillHoles(lumen, isHole);
    }
    if (progress.advance(selectedProgress)) {
        fillCavities(lumen, &progress);
    }
}

/// Fails with `reason` if nothing was traced.
Result<TreeWithSkeleton> failIfEmpty(Result<TreeWithSkeleton> traced, const Error& reason)
{
    return traced && traced.value().vessels.tree.branches.empty() ? Result<TreeWithSkeleton>(reason)
                                                                  : std::move(traced);
}

/// Returns whether the centerlines of the sufficiently wide branches are opacified; those of bone shells, in marrow and
/// between organs are not.
bool isOpacified(const VesselTree& tree, const AxisOrder& order, const VoxelOpacification& opacification)
{
    const Eigen::Affine3d voxelFromPatient = order.geometry.patientFromVoxel().inverse();
    const double minRadiusMm = minEvaluatedRadius * order.geometry.spacingMm.maxCoeff();
    std::vector<double> fills;
    for (const VesselBranch& branch : tree.branches) {
        for (std::size_t n = 0; n < branch.pointsInPatient.size(); ++n) {
            const Eigen::Vector3i at = (voxelFromPatient * branch.pointsInPatient[n]).array().round().cast<int>();
            if (branch.radiusMm[n] >= minRadiusMm && order.geometry.contains(at)) {
                fills.push_back(opacification(at.x(), at.y(), at.z()));
            }
        }
    }
    if (fills.empty()) {
        return true;
    }
    return medianOf(std::move(fills)) >= minAxisFill;
}

/// Without user seeds, adds a message about where tracing started.
TracedVessels addStartMessage(TracedVessels vessels, const SelectedLumen& lumen,
                              const std::vector<GreatVessel>& greatVessels)
{
    if (!lumen.startPointsInPatient.empty()) {
        vessels.foundStart = greatVessels.front().centerInPatient();
    }
    vessels.warnings.insert(vessels.warnings.begin(), startWarning(vessels.foundStart));
    return vessels;
}

/// Adds the threshold, and warnings about the units of the scan and other great vessels.
void addScanWarnings(TracedVessels& vessels, const SelectedLumen& lumen, const std::vector<GreatVessel>& greatVessels,
                     const LumenLevels& level)
{
    vessels.threshold = level.threshold;
    if (const AdjacentLumen other = possibleFalseLumen(lumen.lumen, greatVessels); other.adjacentMm >= minAlongsideMm) {
        vessels.warnings.push_back(adjacentLumenWarning(other));
    }
    if (!level.isHu) {
        vessels.warnings.push_back(unitWarning());
    }
}

/// Traces a mask in patient axis order without segmentation.
Result<TracedVessels> traceLumen(VoxelMask whole, const VolumeGeometry& stored, const VesselTracingOptions& options,
                                 TracingProgress& progress)
{
    if (const auto problem = problemWith(options)) {
        return Error(*problem);
    }
    auto chosen = selectLumen(std::move(whole), options, {}, {}, progress);
    if (!chosen) {
        return chosen.error();
    }
    SelectedLumen lumen = std::move(chosen).value();
    fillCavities(lumen.lumen, &progress);
    auto traced = failIfEmpty(buildTree(lumen, opacificationIn(lumen.lumen), stored, options, progress),
                              Error(messages::noLongBranch()));
    if (!traced) {
        return traced.error();
    }
    TreeWithSkeleton tree = std::move(traced).value();
    const SkeletonCoverage cover = measureCoverage(lumen.lumen.geometry, tree.skeleton, tree.vessels.tree);
    if (cover.fraction < minCoverage && cover.missedInPatient) {
        tree.vessels.warnings.push_back(coverageWarning(cover));
    }
    return std::move(tree.vessels);
}

/// Traces the lumen that `seen` found in its scan.
Result<TracedVessels> traceScan(ScanLumen seen, const Volume& given, const AxisOrder& order,
                                const VesselTracingOptions& options, TracingProgress& progress)
{
    const Volume& volume = seen.scan(given);
    const LumenLevels level = seen.level;
    const VoxelOpacification opacification = voxelOpacification(volume, order, level);
    const std::vector<GreatVessel>& greatVessels = seen.found.greatVessels;
    VesselTracingOptions requested = optionsForScan(options, greatVessels);
    requested.avoidInPatient.insert(requested.avoidInPatient.end(), seen.veins.begin(), seen.veins.end());
    auto chosen = selectLumen(std::move(seen.found.lumen), requested, opacification, greatVessels, progress);
    if (!chosen) {
        return chosen.error();
    }
    SelectedLumen lumen = std::move(chosen).value();
    closeHoles(lumen.lumen, shiftOrigin(opacification, lumen.box.low), progress);
    if (progress.isStopped()) {
        return tracingCanceled();
    }
    const AxisOrder part = crop(order, lumen.box);
    auto traced = failIfEmpty(
        buildTree(lumen, opacificationIn(volume, part, level, lumen.lumen), volume.geometry, requested, progress),
        options.threshold ? Error(messages::noLongBranch()) : noVesselsError(level));
    if (!traced) {
        return traced.error();
    }
    TracedVessels vessels = std::move(traced).value().vessels;
    addScanWarnings(vessels, lumen, greatVessels, level);
    if (seen.corrected) {
        vessels.warnings.push_back(messages::coilBiasCorrected(Quantity{seen.corrected->sensitivityRatio, 1}));
    }
    if (!options.seedsInPatient.empty()) {
        return vessels;
    }
    if (greatVessels.empty() && !options.threshold && !isOpacified(vessels.tree, order, opacification)) {
        return noVesselsError(level);
    }
    if (seen.skull && !options.threshold && runsAlongSkull(vessels.tree, *seen.skull)) {
        return Error(messages::veinsWithArteries());
    }
    return addStartMessage(std::move(vessels), lumen, greatVessels);
}

}   // namespace

Result<TracedVessels> traceMask(const VoxelMask& mask, const VesselTracingOptions& options,
                                const TracingObserver& observe)
{
    if (const auto problem = problemWith(mask.geometry, mask.voxels.size())) {
        return Error(*problem);
    }
    TracingProgress progress(observe);
    progress.enter("vessels", 0.0, 0.7);
    return traceLumen(maskOf(mask, [](std::uint8_t voxel) { return voxel != 0; }), mask.geometry,
                      optionsForMask(options), progress);
}

Result<TracedVessels> traceLabels(const LabelVolume& image, const std::vector<int>& labels,
                                  const VesselTracingOptions& options, const TracingObserver& observe)
{
    if (const auto problem = problemWith(image.geometry, image.voxels.size())) {
        return Error(*problem);
    }
    TracingProgress progress(observe);
    progress.enter("vessels", 0.0, 0.7);
    const std::set<int> requested(labels.begin(), labels.end());
    const auto isVesselLabel = [&](std::uint16_t label) {
        return requested.empty() ? label != 0 : requested.contains(label);
    };
    return traceLumen(maskOf(image, isVesselLabel), image.geometry, optionsForMask(options), progress);
}

Result<TracedVessels> traceVessels(const Volume& volume, const VesselTracingOptions& options,
                                   const TracingObserver& observe)
{
    if (const auto problem = problemWith(volume.geometry, volume.voxels.size())) {
        return Error(*problem);
    }
    if (options.tubesOnly) {
        return traceTubes(volume, options, observe);
    }
    if (const auto problem = problemWith(options)) {
        return Error(*problem);
    }
    TracingProgress progress(observe);
    const AxisOrder order = patientAxisOrder(volume.geometry);
    auto seen = findScanLumen(volume, order, options, progress);
    if (!seen) {
        return seen.error();
    }
    ScanLumen scanLumen = std::move(seen).value();
    return traceScan(std::move(scanLumen), volume, order, options, progress);
}

}   // namespace angiopose::core
