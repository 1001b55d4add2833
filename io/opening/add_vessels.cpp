#include "io/opening/add_vessels.h"

#include "io/messages/messages.h"
#include "io/support/input_bytes.h"
#include "io/surface_file.h"
#include "io/vessel_input_file.h"
#include "io/vessel_tree_file.h"
#include "io/volume_file.h"

#include <filesystem>

namespace angiopose::io {
namespace {

namespace fs = std::filesystem;

/// Returns whether `path` is another slice of the series that is already being opened.
bool isOfSameSeries(const LoadedInputs& inputs, const std::string& path)
{
    return inputs.volume && inputs.vesselInput.kind == core::VesselInputKind::Volume &&
           fs::absolute(path).parent_path() == fs::absolute(inputs.centerlineFile.path).parent_path() &&
           !isVolumeFile(path);
}

/// Adds a scan to display together with vessels that are already present.
core::Status addScan(LoadedInputs& inputs, const std::string& path, const std::string& seriesId,
                     const ReadObserver& observe)
{
    auto read = readVolume(path, seriesId, observe);
    if (!read) {
        return read.error();
    }
    LoadedVolume scan = std::move(read).value();
    inputs.scanIdentity = scan.identity;
    inputs.volume = std::make_shared<const core::Volume>(std::move(scan.volume));
    inputs.warnings.insert(inputs.warnings.end(), scan.warnings.begin(), scan.warnings.end());
    inputs.scanFile.path = path;
    inputs.scanSeriesId = seriesId;
    core::VesselInput asVolume;
    asVolume.kind = core::VesselInputKind::Volume;
    asVolume.seriesId = inputs.scanSeriesId;
    if (const auto hash = sha256OfVesselInput(inputs.scanFile.path, asVolume)) {
        inputs.scanFile.sha256 = hash.value();
    }
    return core::Done{};
}

/// Adds a scan in which nothing could be traced, so that the user can set seeds and a threshold in its slices.
core::Status addUntraced(LoadedInputs& inputs, const std::string& path, const std::string& seriesId,
                         const core::Error& problem, const ReadObserver& observe)
{
    if (!addScan(inputs, path, seriesId, observe)) {
        return problem;
    }
    inputs.warnings.push_back(problem.message.as(core::Severity::Warning));
    return core::Done{};
}

/// Returns the extent of the vessels in file units if the file states no unit and the extent is implausible in mm;
/// nullopt otherwise. Surfaces and most centerline files state no unit; Slicer curves do.
std::optional<double> findImplausibleExtent(const std::string& path, core::VesselInputKind kind)
{
    if (kind == core::VesselInputKind::Surface) {
        const auto surface = readSurface(path);
        const bool isDoubtful = surface && !surface.value().isUnitStated && !isPlausibleSize(surface.value().extentMm);
        return isDoubtful ? std::optional(surface.value().extentMm) : std::nullopt;
    }
    if (kind != core::VesselInputKind::Centerline || extensionOf(path) == ".json") {
        return std::nullopt;
    }
    const auto read = readTree(path);
    const bool isDoubtful = read && !read.value().isUnitStated && !core::isPlausibleSize(read.value().tree);
    return isDoubtful ? std::optional(core::extentMm(read.value().tree)) : std::nullopt;
}

/// Returns the default vessel input of this kind, for hints without `vessels`.
core::VesselInput inputOf(core::VesselInputKind kind, const OpenHints& hints, const std::string& seriesId)
{
    core::VesselInput input;
    input.kind = kind;
    input.seriesId = seriesId;
    input.unitMm = hints.unitMm.value_or(0.0);
    return input;
}

}   // namespace

core::Status addVessels(LoadedInputs& inputs, const std::string& path, const OpenHints& hints,
                        const std::string& seriesId, const ReadObserver& observe)
{
    if (inputs.tree) {
        return isOfSameSeries(inputs, path)
                   ? core::Status(core::Done{})
                   : core::Status(core::Error(messages::openSecondTree(fs::path(path).filename().string())));
    }
    const auto kind = vesselInputKindOf(path);
    if (!kind) {
        return kind.error();
    }
    const bool isScan = kind.value() == core::VesselInputKind::Volume;
    inputs.isScanUseUndecided = isScan && hints.scanUse == ScanUse::Ask;
    if (inputs.isScanUseUndecided) {
        return core::Done{};
    }
    if (isScan && hints.scanUse == ScanUse::ShowWithVessels) {
        return addScan(inputs, path, seriesId, observe);
    }
    if (!hints.unitMm && !hints.vessels) {
        inputs.extentInUnknownUnits = findImplausibleExtent(path, kind.value());
        if (inputs.extentInUnknownUnits) {
            return core::Done{};
        }
    }
    auto read = readVessels(path, hints.vessels.value_or(inputOf(kind.value(), hints, seriesId)), observe);
    if (!read) {
        return isScan && hints.scanUse == ScanUse::TraceOrShow
                   ? addUntraced(inputs, path, seriesId, read.error(), observe)
                   : core::Status(read.error());
    }
    LoadedVessels vessels = std::move(read).value();
    inputs.tree = std::make_shared<core::VesselTree>(std::move(vessels.tree));
    inputs.volume = vessels.volume;
    inputs.lumen = takeSharedLumen(vessels);
    inputs.scanIdentity = vessels.identity;
    inputs.vesselInput = vessels.input;
    inputs.warnings.insert(inputs.warnings.end(), vessels.warnings.begin(), vessels.warnings.end());
    inputs.centerlineFile.path = path;
    return core::Done{};
}

}   // namespace angiopose::io
