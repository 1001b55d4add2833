#include "io/vessel_input_file.h"

#include "core/imaging/fill_surface.h"
#include "core/tracing/volume/trace_vessels.h"
#include "io/dicom/dicom_file.h"
#include "io/dicom_series.h"
#include "io/file_hash.h"
#include "io/label_list.h"
#include "io/messages/messages.h"
#include "io/series/dicom_segmentation.h"
#include "io/support/file_error.h"
#include "io/support/input_bytes.h"
#include "io/support/numbers.h"
#include "io/surface_file.h"
#include "io/vessel_tree_file.h"
#include "io/volume_file.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace angiopose::io {
namespace {

using core::VesselInputKind;

constexpr double largestBodyMm = 10'000.0;
constexpr double surfaceShare = 0.1;   // fraction of the progress due to reading a surface
constexpr double readShare = 0.3;   // fraction of the progress due to reading; the rest is tracing

core::TracingObserver tracingObserver(const ReadObserver& observe)
{
    if (!observe) {
        return {};
    }
    return [observe](const core::TracingReport& report) {
        return observe(readShare + (1.0 - readShare) * report.progress);
    };
}

/// Returns the vessels with only those members that are known before tracing.
LoadedVessels untraced(const core::VesselInput& input, core::Messages warnings)
{
    LoadedVessels loaded;
    loaded.input = input;
    loaded.warnings = std::move(warnings);
    return loaded;
}

core::Result<LoadedVessels> withTree(LoadedVessels loaded, core::Result<core::TracedVessels> traced,
                                     const std::string& path)
{
    if (!traced) {
        return fileError(path, traced.error());
    }
    core::TracedVessels vessels = std::move(traced).value();
    loaded.tree = std::move(vessels.tree);
    loaded.lumen = std::move(vessels.lumen);
    loaded.threshold = vessels.threshold;
    loaded.pieces = std::move(vessels.pieces);
    loaded.warnings.insert(loaded.warnings.end(), vessels.warnings.begin(), vessels.warnings.end());
    if (core::isCompact(loaded.tree)) {
        loaded.warnings.push_back(messages::tracedIsCompact());
    }
    return loaded;
}

core::Result<LoadedVessels> readCenterlines(const std::string& path, const core::VesselInput& input,
                                            const ReadObserver& observe)
{
    VesselTreeReadOptions options;
    options.unitMm = input.unitMm;
    auto read = readTree(path, options, observe);
    if (!read) {
        return read.error();
    }
    LoadedVessels loaded;
    loaded.input = input;
    loaded.warnings = read.value().warnings;
    loaded.tree = std::move(read).value().tree;
    if (!core::isPlausibleSize(loaded.tree)) {
        loaded.warnings.push_back(messages::vesselsUnusualSize(core::Quantity{
            std::round(100.0 * core::extentMm(loaded.tree)) / 100.0, core::Quantity::significantDigits, "mm"}));
    }
    return loaded;
}

core::Result<LoadedVessels> traceSurface(const std::string& path, const core::VesselInput& input,
                                         const ReadObserver& observe)
{
    const auto surface = readSurface(path, input.unitMm, progressPart(observe, 0.0, surfaceShare));
    if (!surface) {
        return surface.error();
    }
    if (surface.value().extentMm > largestBodyMm) {   // the voxels would be as large as vessels, or too many
        return fileError(path,
                         messages::surfaceLargerThanBody(core::Quantity{std::round(surface.value().extentMm / 1000.0),
                                                                        core::Quantity::significantDigits, "m"}));
    }
    const core::SurfaceMesh& mesh = surface.value().mesh;
    if (isStopRequested(observe, surfaceShare)) {
        return readingCanceled(path);
    }
    const auto shouldContinue = [&] { return !isStopRequested(observe, surfaceShare); };
    const auto mask = core::fillSurface(mesh, core::defaultSpacingMm(mesh), shouldContinue);
    if (mask.isStopped()) {
        return readingCanceled(path);
    }
    if (!mask) {
        return fileError(path, mask.error());
    }
    return withTree(untraced(input, surface.value().warnings),
                    core::traceMask(mask.value(), input.tracing, tracingObserver(observe)), path);
}

/// Selects the labels to trace: the requested labels, otherwise those named after vessels, otherwise all. Reports the
/// selection if there are several labels.
core::Status chooseLabels(LoadedVessels& loaded, const core::LabelVolume& image, const std::string& path)
{
    const std::vector<LabelInfo> all = listLabels(image, readLabelNames(path));
    if (all.empty()) {
        return fileError(path, messages::labelsNothingMarked());
    }
    std::vector<int>& chosen = loaded.input.labels;
    for (const int label : chosen) {
        if (std::ranges::none_of(all, [label](const LabelInfo& each) { return each.label == label; })) {
            return fileError(path, messages::labelsNoSuchNumber(label, formatLabels(all)));
        }
    }
    const bool isByName = chosen.empty();
    if (isByName) {
        chosen = vesselLabelsByName(all);
    }
    std::vector<LabelInfo> traced;
    std::vector<LabelInfo> leftOut;
    for (const LabelInfo& each : all) {
        const bool isChosen = chosen.empty() || std::ranges::find(chosen, each.label) != chosen.end();
        (isChosen ? traced : leftOut).push_back(each);
    }
    if (all.size() > 1) {
        loaded.warnings.push_back(messages::labelsTraced(formatLabels(traced)));
    }
    if (isByName && !leftOut.empty()) {
        loaded.warnings.push_back(messages::labelsLeftOut(formatLabels(leftOut)));
    }
    return core::Done{};
}

core::Result<LoadedVessels> traceLabelImage(LoadedVessels loaded, const core::LabelVolume& image,
                                            const std::string& path, const ReadObserver& observe)
{
    if (const core::Status chosen = chooseLabels(loaded, image, path); !chosen) {
        return chosen.error();
    }
    auto traced = core::traceLabels(image, loaded.input.labels, loaded.input.tracing, tracingObserver(observe));
    return withTree(std::move(loaded), std::move(traced), path);
}

core::Result<LoadedVessels> traceSegmentation(const std::string& path, const core::VesselInput& input,
                                              const ReadObserver& observe)
{
    const auto labels = readLabels(path, progressPart(observe, 0.0, readShare));
    if (!labels) {
        return labels.error();
    }
    const auto header = isVolumeFile(path) ? describeVolume(path) : core::Result<VolumeSummary>(VolumeSummary{});
    core::Messages warnings = header ? header.value().warnings : core::Messages();
    std::erase_if(warnings, [](const core::Message& warning) { return warning.is(messages::volumeSizeOfOne); });
    return traceLabelImage(untraced(input, std::move(warnings)), labels.value(), path, observe);
}

core::Result<LoadedVessels> traceVolume(const std::string& path, core::VesselInput input, const ReadObserver& observe)
{
    auto read = readVolume(path, input.seriesId, progressPart(observe, 0.0, readShare));
    if (!read) {
        return read.error();
    }
    LoadedVolume loaded = std::move(read).value();
    if (isFolder(path)) {
        input.seriesId = loaded.seriesId;
    }
    if (looksLikeLabels(loaded.volume)) {
        loaded.warnings.push_back(messages::volumeHoldsLabels());
        input.kind = VesselInputKind::Segmentation;
        return traceLabelImage(untraced(input, loaded.warnings), labelsOf(loaded.volume), path, observe);
    }
    auto vessels = traceScan(std::make_shared<const core::Volume>(std::move(loaded.volume)), path, input, observe);
    if (!vessels) {
        return vessels;
    }
    LoadedVessels traced = std::move(vessels).value();
    traced.identity = loaded.identity;
    traced.warnings.insert(traced.warnings.begin(), loaded.warnings.begin(), loaded.warnings.end());
    return traced;
}

/// Reads a VTK file to determine whether it contains lines or a surface.
VesselInputKind kindOfVtk(const std::string& path)
{
    return !readVesselTree(path) && readSurface(path) ? VesselInputKind::Surface : VesselInputKind::Centerline;
}

}   // namespace

std::shared_ptr<const core::VoxelMask> takeSharedLumen(LoadedVessels& vessels)
{
    return vessels.lumen.voxels.empty() ? nullptr : std::make_shared<const core::VoxelMask>(std::move(vessels.lumen));
}

core::Result<VesselInputKind> vesselInputKindOf(const std::string& path)
{
    if (isFolder(path)) {
        return VesselInputKind::Volume;
    }
    const auto input = openInputStart(path);
    if (!input) {
        return input.error();
    }
    const std::string_view content = input.value().view();
    const std::string extension = extensionOf(path);
    const bool isVolume = isVolumeFile(path);
    if (const auto summary = isVolume ? std::optional(describeVolume(path)) : std::nullopt; summary && *summary) {
        return summary->value().isDeclaredLabelMap ? VesselInputKind::Segmentation : VesselInputKind::Volume;
    }
    if (isVolumeFile(path) || isDicomFile(path)) {
        return isDicomSegmentation(path) ? VesselInputKind::Segmentation : VesselInputKind::Volume;
    }
    if (extension == ".stl" || extension == ".ply" || extension == ".obj" || content.starts_with("ply")) {
        return VesselInputKind::Surface;
    }
    const bool isVtk =
        content.starts_with("# vtk DataFile") || content.substr(0, 4096).find("<VTKFile") != std::string_view::npos;
    return isVtk ? kindOfVtk(path) : VesselInputKind::Centerline;
}

core::Result<LoadedVessels> traceScan(const std::shared_ptr<const core::Volume>& scan, const std::string& path,
                                      const core::VesselInput& input, const ReadObserver& observe)
{
    LoadedVessels vessels = untraced(input, {});
    vessels.volume = scan;
    return withTree(std::move(vessels), core::traceVessels(*scan, input.tracing, tracingObserver(observe)), path);
}

core::Result<LoadedVessels> readVessels(const std::string& path, const core::VesselInput& input,
                                        const ReadObserver& observe)
{
    switch (input.kind) {
        case VesselInputKind::Segmentation:
            return traceSegmentation(path, input, observe);
        case VesselInputKind::Surface:
            return traceSurface(path, input, observe);
        case VesselInputKind::Volume:
            return traceVolume(path, input, observe);
        default:
            return readCenterlines(path, input, observe);
    }
}

core::Result<std::string> sha256OfVesselInput(const std::string& path, const core::VesselInput& input)
{
    if (!isFolder(path)) {
        return sha256OfFile(path);
    }
    const auto all = listSeries(path);
    if (!all) {
        return all.error();
    }
    for (const DicomSeries& series : all.value()) {
        if (series.id == input.seriesId || (input.seriesId.empty() && !series.problem && !series.isAngiogram)) {
            return sha256OfSeries(series);
        }
    }
    return fileError(path, messages::seriesOfCaseNotHere());
}

}   // namespace angiopose::io
