#include "core/tracing/volume/trace_vessels.h"

#include "core/messages/messages.h"
#include "core/support/parallel_for.h"
#include "core/support/quantile.h"
#include "core/tracing/tree/lumen_tree.h"
#include "core/tracing/tree/skeleton_cover.h"
#include "core/tracing/volume/chosen/chosen_lumen.h"
#include "core/tracing/volume/chosen/fill_cavities.h"
#include "core/tracing/volume/chosen/other_lumen.h"
#include "core/tracing/volume/lumen/blood_level.h"
#include "core/tracing/volume/lumen/segment_lumen.h"
#include "core/tracing/volume/path/trace_tubes.h"
#include "core/tracing/volume/piece_report.h"
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
constexpr double minFilledRadius = 1.5;   ///< in voxels; blurring dims the axis of thinner vessels
constexpr double minAxisFill = 0.65;   ///< minimum median opacification of the branch axes
constexpr double minBesideMm = 80.0;   ///< minimum length beside a great vessel; pulmonary arteries reach under half
constexpr double minFollowed = 0.98;   ///< minimum covered fraction of a mask's skeleton; below, a warning is issued
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
VoxelMask asStored(const VoxelMask& part, const VoxelBox& box, const VolumeGeometry& stored)
{
    VoxelMask whole(stored);
    const AxisOrder order = cropped(patientAxisOrder(stored), box);
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
VesselTracingOptions withPiecesOfMask(VesselTracingOptions options)
{
    options.pieces = !options.seedsInPatient.empty()           ? TracedPieces::Usual
                     : options.pieces == TracedPieces::Largest ? TracedPieces::Largest
                                                               : TracedPieces::All;
    return options;
}

/// Returns the options for a scan: only components of great vessels are traced.
VesselTracingOptions withPiecesOfScan(VesselTracingOptions options, const std::vector<GreatVessel>& great)
{
    if (great.empty() || !options.seedsInPatient.empty()) {
        options.pieces = TracedPieces::Usual;
    }
    return options;
}

/// Tree of a lumen, with the skeleton it was derived from.
struct TreeOfLumen {
    TracedVessels vessels;
    std::vector<std::size_t> skeleton;   ///< voxels of the selected lumen
};

Result<TreeOfLumen> treeOf(const ChosenLumen& chosen, const BloodFill& fill, const VolumeGeometry& stored,
                           const VesselTracingOptions& options, TracingProgress& progress)
{
    VesselTracingOptions chosenOptions = options;
    chosenOptions.seedsInPatient = chosen.startsInPatient;
    LumenTree found = lumenTree(chosen.lumen, fill, chosenOptions, progress);
    if (progress.isStopped()) {
        return stoppedTracing();
    }
    TracedVessels traced;
    traced.tree = std::move(found.tree);
    traced.lumen = asStored(chosen.lumen, chosen.box, stored);
    traced.threshold = 0.5;
    traced.warnings = chosen.warnings;
    traced.pieces = reportedPieces(chosen.lumen, traced.tree, chosen.leftOut, progress);
    const Messages ofPieces = pieceWarnings(traced.pieces, !options.seedsInPatient.empty());
    traced.warnings.insert(traced.warnings.end(), ofPieces.begin(), ofPieces.end());
    if (progress.isStopped()) {
        return stoppedTracing();
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
    if (found.dimParts > 0) {
        traced.warnings.push_back(dimWarning(found.dimParts));
    }
    return TreeOfLumen{std::move(traced), std::move(found.skeleton)};
}

/// Accepts holes caused by noise, which darkens single voxels; the wall between two touching vessels is a dark sheet.
HoleFilter noiseHoles(const VoxelFill& fill)
{
    return [&fill](int i, int j, int k) {   // never called at the boundary
        const double sum = fill(i, j, k) + fill(i - 1, j, k) + fill(i + 1, j, k) + fill(i, j - 1, k) +
                           fill(i, j + 1, k) + fill(i, j, k - 1) + fill(i, j, k + 1);
        return sum > 7.0 * minHoleFill;
    };
}

/// Closes holes in `lumen` caused by noise or calcified plaque; stops on request.
void closeHoles(VoxelMask& lumen, const VoxelFill& fill, TracingProgress& progress)
{
    const HoleFilter isHole = noiseHoles(fill);
    for (int round = 0; round < holeRounds && progress.advance(chosenShare); ++round) {
        fillHoles(lumen, isHole);
    }
    if (progress.advance(chosenShare)) {
        fillCavities(lumen, &progress);
    }
}

/// Fails with `reason` if nothing was traced.
Result<TreeOfLumen> unlessEmpty(Result<TreeOfLumen> traced, const Error& reason)
{
    return traced && traced.value().vessels.tree.branches.empty() ? Result<TreeOfLumen>(reason) : std::move(traced);
}

/// Returns whether the axes of the sufficiently wide branches are opacified; axes of bone shells, in marrow and between
/// organs are not.
bool isOpacified(const VesselTree& tree, const AxisOrder& order, const VoxelFill& fill)
{
    const Eigen::Affine3d voxelFromPatient = order.geometry.patientFromVoxel().inverse();
    const double minRadiusMm = minFilledRadius * order.geometry.spacingMm.maxCoeff();
    std::vector<double> fills;
    for (const VesselBranch& branch : tree.branches) {
        for (std::size_t n = 0; n < branch.pointsInPatient.size(); ++n) {
            const Eigen::Vector3i at = (voxelFromPatient * branch.pointsInPatient[n]).array().round().cast<int>();
            if (branch.radiusMm[n] >= minRadiusMm && order.geometry.contains(at)) {
                fills.push_back(fill(at.x(), at.y(), at.z()));
            }
        }
    }
    if (fills.empty()) {
        return true;
    }
    return medianOf(std::move(fills)) >= minAxisFill;
}

/// Without user seeds, adds a message about where tracing started.
TracedVessels startedBy(TracedVessels vessels, const ChosenLumen& lumen, const std::vector<GreatVessel>& great)
{
    if (!lumen.startsInPatient.empty()) {
        vessels.foundStart = great.front().middleInPatient();
    }
    vessels.warnings.insert(vessels.warnings.begin(), startWarning(vessels.foundStart));
    return vessels;
}

/// Adds the threshold, and warnings about the units of the scan and other great vessels.
void tellOfScan(TracedVessels& vessels, const ChosenLumen& lumen, const std::vector<GreatVessel>& great,
                const BloodLevel& level)
{
    vessels.threshold = level.threshold;
    if (const OtherLumen other = otherLumenBeside(lumen.lumen, great); other.besideMm >= minBesideMm) {
        vessels.warnings.push_back(besideWarning(other));
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
    auto chosen = chosenLumen(std::move(whole), options, {}, {}, progress);
    if (!chosen) {
        return chosen.error();
    }
    ChosenLumen lumen = std::move(chosen).value();
    fillCavities(lumen.lumen, &progress);
    auto traced =
        unlessEmpty(treeOf(lumen, fillOf(lumen.lumen), stored, options, progress), Error(messages::noLongBranch()));
    if (!traced) {
        return traced.error();
    }
    TreeOfLumen tree = std::move(traced).value();
    const SkeletonCover cover = skeletonCover(lumen.lumen.geometry, tree.skeleton, tree.vessels.tree);
    if (cover.share < minFollowed && cover.missedInPatient) {
        tree.vessels.warnings.push_back(coverWarning(cover));
    }
    return std::move(tree.vessels);
}

/// Traces the lumen that `seen` found in its scan.
Result<TracedVessels> traceScan(ScanLumen seen, const Volume& given, const AxisOrder& order,
                                const VesselTracingOptions& options, TracingProgress& progress)
{
    const Volume& volume = seen.scan(given);
    const BloodLevel level = seen.level;
    const VoxelFill fill = bloodShare(volume, order, level);
    const std::vector<GreatVessel>& great = seen.found.great;
    VesselTracingOptions asked = withPiecesOfScan(options, great);
    asked.avoidInPatient.insert(asked.avoidInPatient.end(), seen.veins.begin(), seen.veins.end());
    auto chosen = chosenLumen(std::move(seen.found.lumen), asked, fill, great, progress);
    if (!chosen) {
        return chosen.error();
    }
    ChosenLumen lumen = std::move(chosen).value();
    closeHoles(lumen.lumen, movedBy(fill, lumen.box.low), progress);
    if (progress.isStopped()) {
        return stoppedTracing();
    }
    const AxisOrder part = cropped(order, lumen.box);
    auto traced = unlessEmpty(treeOf(lumen, fillOf(volume, part, level, lumen.lumen), volume.geometry, asked, progress),
                              options.threshold ? Error(messages::noLongBranch()) : noVesselsFound(level));
    if (!traced) {
        return traced.error();
    }
    TracedVessels vessels = std::move(traced).value().vessels;
    tellOfScan(vessels, lumen, great, level);
    if (seen.corrected) {
        vessels.warnings.push_back(messages::coilBiasCorrected(Quantity{seen.corrected->fallOff, 1}));
    }
    if (!options.seedsInPatient.empty()) {
        return vessels;
    }
    if (great.empty() && !options.threshold && !isOpacified(vessels.tree, order, fill)) {
        return noVesselsFound(level);
    }
    if (seen.skull && !options.threshold && runsAlongSkull(vessels.tree, *seen.skull)) {
        return Error(messages::veinsWithArteries());
    }
    return startedBy(std::move(vessels), lumen, great);
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
                      withPiecesOfMask(options), progress);
}

Result<TracedVessels> traceLabels(const LabelVolume& image, const std::vector<int>& labels,
                                  const VesselTracingOptions& options, const TracingObserver& observe)
{
    if (const auto problem = problemWith(image.geometry, image.voxels.size())) {
        return Error(*problem);
    }
    TracingProgress progress(observe);
    progress.enter("vessels", 0.0, 0.7);
    const std::set<int> asked(labels.begin(), labels.end());
    const auto isAsked = [&](std::uint16_t label) { return asked.empty() ? label != 0 : asked.contains(label); };
    return traceLumen(maskOf(image, isAsked), image.geometry, withPiecesOfMask(options), progress);
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
    ScanLumen ground = std::move(seen).value();
    return traceScan(std::move(ground), volume, order, options, progress);
}

}   // namespace angiopose::core
