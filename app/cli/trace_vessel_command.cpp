#include "app/cli/commands.h"
#include "app/messages/messages.h"
#include "app/texts/number_text.h"
#include "core/tracing/volume/path/vessel_path.h"
#include "core/vessel/add_branch.h"
#include "io/label_list.h"
#include "io/support/input_bytes.h"
#include "io/surface_file.h"
#include "io/vessel_input_file.h"
#include "io/vessel_tree_file.h"
#include "io/volume_file.h"

#include <algorithm>
#include <cstdio>

namespace angiopose::app {
namespace {

core::VesselInput vesselInputOf(const TraceVesselArguments& arguments, core::VesselInputKind kind)
{
    core::VesselInput input;
    input.kind = kind;
    input.seriesId = arguments.seriesId;
    input.unitMm = arguments.unitMm;
    input.tracing = arguments.tracing;
    return input;
}

/// Returns the labels named by the arguments; reads the file to look them up.
core::Result<std::vector<int>> requestedLabels(const TraceVesselArguments& arguments)
{
    if (arguments.labels.empty()) {
        return std::vector<int>();
    }
    const auto listed = io::listLabelsOfFile(arguments.inputPath);
    if (!listed) {
        return core::Error(messages::traceNoLabels().about(arguments.inputPath));
    }
    auto labels = io::findLabels(arguments.labels, *listed);
    return labels ? labels : labels.error().about(arguments.inputPath);
}

/// Returns the error for a file that cannot be traced because it is not a volume, segmentation or surface.
core::Error notTraceableError(const std::string& path)
{
    if (io::readVesselTree(path)) {
        return messages::traceCenterlines().about(path);
    }
    const std::string extension = io::extensionOf(path);
    if (extension == ".vtp" || extension == ".vtk" || extension == ".vtu") {   // contains neither lines nor triangles
        const auto surface = io::readSurface(path);
        return surface ? core::Error(messages::traceOtherSurface().about(path)) : surface.error();
    }
    const auto volume = io::readVolume(path);   // the read error states what the file contains instead
    return volume ? core::Error(messages::traceNoScan().about(path)) : volume.error();
}

core::LabelVolume labelsOf(const core::VoxelMask& mask)
{
    core::LabelVolume labels(mask.geometry);
    std::transform(mask.voxels.begin(), mask.voxels.end(), labels.voxels.begin(),
                   [](std::uint8_t voxel) { return static_cast<std::uint16_t>(voxel != 0 ? 1 : 0); });
    return labels;
}

std::string described(const core::VesselTree& tree)
{
    double lengthMm = 0.0;
    for (const core::VesselBranch& branch : tree.branches) {
        lengthMm += branch.lengthMm();
    }
    const std::size_t count = tree.branches.size();
    return std::to_string(count) + (count == 1 ? " branch, " : " branches, ") + fixedText(lengthMm, 1) + " mm";
}

/// Reads the tree to which single vessels are added; returns an empty tree if no file is given.
core::Result<core::VesselTree> treeToAddTo(const TraceVesselArguments& arguments)
{
    return arguments.baseTreePath.empty() ? core::VesselTree() : io::readVesselTree(arguments.baseTreePath);
}

/// Traces a vessel section, adds it to the tree and reports it.
core::Status addSection(core::VesselTree& tree, const core::Volume& scan, const VesselSection& stretch)
{
    auto path = core::traceVesselBetween(scan, stretch.from, stretch.to, [](const core::TracingReport&) {
        return isInterrupted() ? core::ObserverDecision::Stop : core::ObserverDecision::Continue;
    });
    if (!path) {
        return path.error();
    }
    printWarnings(path.value().warnings);
    auto added = core::attachBranch(tree, std::move(path).value().branch);
    if (!added) {
        return added.error();
    }
    tree = std::move(added).value();
    return core::Done{};
}

int traceStretches(const TraceVesselArguments& arguments)
{
    auto tree = treeToAddTo(arguments);
    if (!tree) {
        return reportInputError(tree.error());
    }
    const auto scan = io::readVolume(arguments.inputPath, arguments.seriesId);
    if (!scan) {
        return reportInputError(scan.error());
    }
    printWarnings(scan.value().warnings);
    core::VesselTree grown = std::move(tree).value();
    for (const VesselSection& stretch : arguments.sections) {
        if (const auto added = addSection(grown, scan.value().volume, stretch); !added) {
            return reportInputError(added.error().about(arguments.inputPath));
        }
    }
    if (const auto written = io::writeVesselTree(grown, arguments.outputPath); !written) {
        return reportInputError(written.error());
    }
    std::printf("%s: %s\n", arguments.outputPath.c_str(), described(grown).c_str());
    return exitSuccess;
}

constexpr double minPieceShare = 0.005;   ///< fraction of all voxels below which a component is noise, not a vessel

/// If there are several connected components, prints each one with a seed that selects it, and summarizes small omitted
/// ones in one line.
void printPieces(const std::vector<core::TracedComponent>& pieces)
{
    int crumbs = 0;
    double shareOfCrumbs = 0.0;
    for (std::size_t n = 0; pieces.size() > 1 && n < pieces.size(); ++n) {
        const core::TracedComponent& piece = pieces[n];
        if (!piece.isTraced() && piece.share < minPieceShare) {
            ++crumbs;
            shareOfCrumbs += piece.share;
            continue;
        }
        const Eigen::Vector3d& place = piece.positionInPatient;
        const std::string length = piece.isTraced() ? fixedText(piece.lengthMm, 1) + " mm" : std::string("left out");
        std::printf("component %zu: %s, %s %% of the voxels, --seed=%s,%s,%s\n", n + 1, length.c_str(),
                    fixedText(100.0 * piece.share, 2).c_str(), fixedText(place.x(), 2).c_str(),
                    fixedText(place.y(), 2).c_str(), fixedText(place.z(), 2).c_str());
    }
    if (crumbs > 0) {
        std::printf("%d small components with %s %% of the voxels in total: omitted\n", crumbs,
                    fixedText(100.0 * shareOfCrumbs, 2).c_str());
    }
}

}   // namespace

int runTraceVessel(const TraceVesselArguments& arguments)
{
    if (!arguments.sections.empty()) {
        return traceStretches(arguments);
    }
    auto kind = io::vesselInputKindOf(arguments.inputPath);
    if (!kind) {
        return reportInputError(kind.error());
    }
    if (kind.value() == core::VesselInputKind::Centerline) {
        return reportInputError(notTraceableError(arguments.inputPath));
    }
    if (!arguments.labels.empty() && kind.value() == core::VesselInputKind::Volume) {
        kind = core::VesselInputKind::Segmentation;
    }
    if (arguments.tracing.tubesOnly && kind.value() != core::VesselInputKind::Volume) {
        return reportInputError(core::Error(messages::traceTubesOfMask().about(arguments.inputPath)));
    }
    const auto labels = requestedLabels(arguments);
    if (!labels) {
        return reportInputError(labels.error());
    }
    core::VesselInput input = vesselInputOf(arguments, kind.value());
    input.labels = labels.value();
    ProgressLine progress("tracing");
    const auto vessels = io::readVessels(arguments.inputPath, input, [&progress](double fraction) {
        progress.show(fraction, "");
        return isInterrupted() ? core::ObserverDecision::Stop : core::ObserverDecision::Continue;
    });
    if (!vessels) {
        return reportInputError(vessels.error());
    }
    printWarnings(vessels.value().warnings);
    if (const auto written = io::writeVesselTree(vessels.value().tree, arguments.outputPath); !written) {
        return reportInputError(written.error());
    }
    if (!arguments.maskPath.empty()) {
        if (const auto written = io::writeLabels(labelsOf(vessels.value().lumen), arguments.maskPath); !written) {
            return reportInputError(written.error());
        }
    }
    std::printf("%s: %s%s\n", arguments.outputPath.c_str(), described(vessels.value().tree).c_str(),
                vessels.value().volume ? (", lumen above " + fixedText(vessels.value().threshold, 1)).c_str() : "");
    printPieces(vessels.value().pieces);
    return exitSuccess;
}

}   // namespace angiopose::app
