#include "app/cli/commands.h"
#include "app/messages/says.h"
#include "app/texts/number_text.h"
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

/// The labels that the arguments name; the file is read for it.
core::Result<std::vector<int>> labelsAskedFor(const TraceVesselArguments& arguments)
{
    if (arguments.labels.empty()) {
        return std::vector<int>();
    }
    const auto listed = io::labelsIn(arguments.inputPath);
    if (!listed) {
        return core::Error(says::traceNoLabels().about(arguments.inputPath));
    }
    auto labels = io::labelsCalled(arguments.labels, *listed);
    return labels ? labels : labels.error().about(arguments.inputPath);
}

/// Of a file that is no volume, segmentation or surface.
core::Error whyNotTraced(const std::string& path)
{
    if (io::readVesselTree(path)) {
        return says::traceCentrelines().about(path);
    }
    const std::string extension = io::extensionOf(path);
    if (extension == ".vtp" || extension == ".vtk" || extension == ".vtu") {   // neither lines nor triangles
        const auto surface = io::readSurface(path);
        return surface ? core::Error(says::traceOtherSurface().about(path)) : surface.error();
    }
    const auto volume = io::readVolume(path);   // says what the file is instead
    return volume ? core::Error(says::traceNoScan().about(path)) : volume.error();
}

core::LabelVolume labelsOf(const core::VoxelMask& mask)
{
    core::LabelVolume labels(mask.geometry);
    std::transform(mask.voxels.begin(), mask.voxels.end(), labels.voxels.begin(),
                   [](std::uint8_t voxel) { return static_cast<std::uint16_t>(voxel != 0 ? 1 : 0); });
    return labels;
}

void printTree(const io::LoadedVessels& vessels, const std::string& path)
{
    double lengthMm = 0.0;
    for (const core::VesselBranch& branch : vessels.tree.branches) {
        lengthMm += branch.lengthMm();
    }
    const std::size_t count = vessels.tree.branches.size();
    std::printf("%s: %zu %s, %s mm", path.c_str(), count, count == 1 ? "branch" : "branches",
                fixedText(lengthMm, 1).c_str());
    if (vessels.volume) {
        std::printf(", lumen above %s", fixedText(vessels.threshold, 1).c_str());
    }
    std::printf("\n");
}

}   // namespace

int runTraceVessel(const TraceVesselArguments& arguments)
{
    auto kind = io::vesselInputKindOf(arguments.inputPath);
    if (!kind) {
        return failInput(kind.error());
    }
    if (kind.value() == core::VesselInputKind::Centerline) {
        return failInput(whyNotTraced(arguments.inputPath));
    }
    if (!arguments.labels.empty() && kind.value() == core::VesselInputKind::Volume) {
        kind = core::VesselInputKind::Segmentation;
    }
    const auto labels = labelsAskedFor(arguments);
    if (!labels) {
        return failInput(labels.error());
    }
    core::VesselInput input = vesselInputOf(arguments, kind.value());
    input.labels = labels.value();
    ProgressLine progress("tracing");
    const auto vessels = io::readVessels(arguments.inputPath, input, [&progress](double fraction) {
        progress.show(fraction, "");
        return isInterrupted() ? core::Verdict::Stop : core::Verdict::Continue;
    });
    if (!vessels) {
        return failInput(vessels.error());
    }
    printWarnings(vessels.value().warnings);
    if (const auto written = io::writeVesselTree(vessels.value().tree, arguments.outputPath); !written) {
        return failInput(written.error());
    }
    if (!arguments.maskPath.empty()) {
        if (const auto written = io::writeLabels(labelsOf(vessels.value().lumen), arguments.maskPath); !written) {
            return failInput(written.error());
        }
    }
    printTree(vessels.value(), arguments.outputPath);
    return exitDone;
}

}   // namespace angiopose::app