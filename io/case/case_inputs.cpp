#include "io/case/case_inputs.h"

#include "io/case/view_inputs.h"
#include "io/file_hash.h"
#include "io/messages/messages.h"
#include "io/vessel_input_file.h"
#include "io/volume_file.h"

#include <algorithm>
#include <filesystem>

namespace angiopose::io {
namespace {

namespace fs = std::filesystem;
using core::Case;
using core::Vessels;

/// Reads the scan shown with vessels from another file. The scan is optional, so failure only causes a warning.
void readScan(Vessels& vessels, core::Messages& warnings)
{
    if (vessels.scanFile.path.empty()) {
        return;
    }
    auto read = readVolume(vessels.scanFile.path, vessels.scanSeriesId);
    if (!read) {
        warnings.push_back(read.error().message);
        return;
    }
    LoadedVolume scan = std::move(read).value();
    vessels.scanIdentity = scan.identity;
    vessels.scan = std::make_shared<const core::Volume>(std::move(scan.volume));
    core::VesselInput input;
    input.kind = core::VesselInputKind::Volume;
    input.seriesId = vessels.scanSeriesId;
    if (const auto checked = checkHash(vessels.scanFile, sha256OfVesselInput(vessels.scanFile.path, input), warnings);
        !checked) {
        warnings.push_back(checked.error().message);
    }
}

/// Reads the manually edited mask even if the tree was edited as well; otherwise the next save would lose the mask.
void readEditedLumen(Vessels& vessels, core::Messages& warnings, const ReadObserver& observe)
{
    auto read = readLabels(vessels.file.path, observe);
    if (!read) {
        warnings.push_back(read.error().message);
        return;
    }
    auto lumen = std::make_shared<core::VoxelMask>(read.value().geometry);
    std::ranges::transform(read.value().voxels, lumen->voxels.begin(),
                           [](std::uint16_t label) { return static_cast<std::uint8_t>(label != 0 ? 1 : 0); });
    vessels.lumen = std::move(lumen);
}

/// Reads the input from which an edited tree was traced, because the slice views need its scan. The case stores the
/// tree itself, so failure only causes a warning.
void readOrigin(Vessels& vessels, core::Messages& warnings, const ReadObserver& observe)
{
    const std::string& path = vessels.file.path;
    if (vessels.input.kind == core::VesselInputKind::Volume) {
        if (auto read = readVolume(path, vessels.input.seriesId, observe)) {
            LoadedVolume scan = std::move(read).value();
            vessels.scanIdentity = scan.identity;
            vessels.scan = std::make_shared<const core::Volume>(std::move(scan.volume));
        } else {
            warnings.push_back(read.error().message);
        }
    }
    if (vessels.isLumenEdited) {
        readEditedLumen(vessels, warnings, observe);
    }
    const core::InputFile noted = vessels.file;
    if (const auto checked = checkHash(vessels.file, sha256OfVesselInput(path, vessels.input), warnings); !checked) {
        vessels.file = noted;
        warnings.push_back(messages::caseOpensWithout(checked.error().message));
    }
}

core::Status readVesselInput(Vessels& vessels, core::Messages& warnings, const ReadObserver& observe)
{
    if (vessels.isTreeEdited) {
        readOrigin(vessels, warnings, observe);
        return core::Done{};
    }
    auto read = readVessels(vessels.file.path, vessels.input, observe);
    if (!read) {
        return read.error();
    }
    LoadedVessels loaded = std::move(read).value();
    vessels.input = loaded.input;
    vessels.scan = loaded.volume;
    vessels.lumen = takeSharedLumen(loaded);
    vessels.scanIdentity = loaded.identity;
    vessels.tree = std::make_shared<const core::VesselTree>(std::move(loaded.tree));
    warnings.insert(warnings.end(), loaded.warnings.begin(), loaded.warnings.end());
    return checkHash(vessels.file, sha256OfVesselInput(vessels.file.path, vessels.input), warnings);
}

void dropUnknownBranches(std::vector<int>& ids, const core::VesselTree& tree, const char* key, core::Messages& warnings)
{
    std::erase_if(ids, [&](int id) {
        const bool isUnknown = tree.find(id) == nullptr;
        if (isUnknown) {
            warnings.push_back(messages::caseBranchLeftOut(id).about(std::string("vessel.") + key));
        }
        return isUnknown;
    });
}

}   // namespace

std::vector<core::InputFile*> inputsOf(CaseDocument& document)
{
    std::vector<core::InputFile*> files;
    const auto add = [&files](core::InputFile& file) {
        if (!file.path.empty()) {
            files.push_back(&file);
        }
    };
    add(document.values.vessels.file);
    add(document.values.vessels.scanFile);
    for (core::View& view : document.values.views) {
        add(view.imageFile);
        add(view.target.file);
        add(view.caseFile);
        add(view.followed.deformationsFile);
    }
    return files;
}

void makePathsAbsolute(CaseDocument& document, const std::string& casePath)
{
    const fs::path folder = fs::absolute(casePath).parent_path();
    for (core::InputFile* file : inputsOf(document)) {
        file->path = (folder / fs::path(file->path)).lexically_normal().string();
    }
}

core::Result<Case> loadInputs(CaseDocument document, const std::string& casePath, core::Messages& warnings,
                              const ReadObserver& observe, PeakFrameSearch peak)
{
    Case& values = document.values;
    if (auto read = readVesselInput(values.vessels, warnings, progressPart(observe, 0.0, 0.9)); !read) {
        return read.error();
    }
    readScan(values.vessels, warnings);
    if (const auto read = loadView(values.shown(), document.notes.front(), values.vessels, casePath, warnings, peak);
        !read) {
        return read.error();
    }
    core::Vessels& vessels = values.vessels;
    dropUnknownBranches(vessels.auxiliaryBranchIds, *vessels.tree, "auxiliaryBranches", warnings);
    dropUnknownBranches(vessels.excludedBranchIds, *vessels.tree, "excludedBranches", warnings);
    dropUnknownBranches(vessels.hiddenBranchIds, *vessels.tree, "hiddenBranches", warnings);
    return std::move(values);
}

}   // namespace angiopose::io
