#include "io/case/case_inputs.h"

#include "io/case/view_inputs.h"
#include "io/file_hash.h"
#include "io/messages/says.h"
#include "io/vessel_input_file.h"
#include "io/volume_file.h"

#include <filesystem>

namespace angiopose::io {
namespace {

namespace fs = std::filesystem;
using core::RegistrationCase;

/// The scan that vessels of another origin lie in: good to have, but the case opens without it.
void readScan(RegistrationCase& values, core::Messages& warnings)
{
    if (values.scanFile.path.empty()) {
        return;
    }
    auto read = readVolume(values.scanFile.path, values.scanSeriesId);
    if (!read) {
        warnings.push_back(read.error().message);
        return;
    }
    LoadedVolume scan = std::move(read).value();
    values.scanIdentity = scan.identity;
    values.volume = std::make_shared<const core::Volume>(std::move(scan.volume));
    core::VesselInput input;
    input.kind = core::VesselInputKind::Volume;
    input.seriesId = values.scanSeriesId;
    if (const auto checked = checkHash(values.scanFile, sha256OfVesselInput(values.scanFile.path, input), warnings);
        !checked) {
        warnings.push_back(checked.error().message);
    }
}

/// What an edited tree came from: its scan is read for the slices. The tree is the case's own, so that it opens
/// without.
void readOrigin(RegistrationCase& values, core::Messages& warnings, const ReadObserver& observe)
{
    const std::string& path = values.centerlineFile.path;
    if (values.vesselInput.kind == core::VesselInputKind::Volume) {
        if (auto read = readVolume(path, values.vesselInput.seriesId, observe)) {
            LoadedVolume scan = std::move(read).value();
            values.scanIdentity = scan.identity;
            values.volume = std::make_shared<const core::Volume>(std::move(scan.volume));
        } else {
            warnings.push_back(read.error().message);
        }
    }
    const core::InputFile noted = values.centerlineFile;
    if (const auto checked = checkHash(values.centerlineFile, sha256OfVesselInput(path, values.vesselInput), warnings);
        !checked) {
        values.centerlineFile = noted;
        warnings.push_back(says::caseOpensWithout(checked.error().message));
    }
}

core::Status readVesselInput(RegistrationCase& values, core::Messages& warnings, const ReadObserver& observe)
{
    if (values.isTreeEdited) {
        readOrigin(values, warnings, observe);
        return core::Done{};
    }
    auto read = readVessels(values.centerlineFile.path, values.vesselInput, observe);
    if (!read) {
        return read.error();
    }
    LoadedVessels vessels = std::move(read).value();
    values.vesselInput = vessels.input;
    values.volume = vessels.volume;
    values.lumen = sharedLumen(vessels);
    values.scanIdentity = vessels.identity;
    values.tree = std::make_shared<const core::VesselTree>(std::move(vessels.tree));
    warnings.insert(warnings.end(), vessels.warnings.begin(), vessels.warnings.end());
    return checkHash(values.centerlineFile, sha256OfVesselInput(values.centerlineFile.path, values.vesselInput),
                     warnings);
}

void dropUnknownBranches(std::vector<int>& ids, const core::VesselTree& tree, const char* key, core::Messages& warnings)
{
    std::erase_if(ids, [&](int id) {
        const bool isUnknown = tree.find(id) == nullptr;
        if (isUnknown) {
            warnings.push_back(says::caseBranchLeftOut(id).about(std::string("vessel.") + key));
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
    for (core::InputFile* file : {&document.values.centerlineFile, &document.values.scanFile,
                                  &document.values.imageFile, &document.values.targetFile}) {
        add(*file);
    }
    for (core::OtherView& other : document.values.otherViews) {
        add(other.file);
    }
    for (CaseDocument& view : document.views) {
        add(view.values.imageFile);
        add(view.values.targetFile);
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

core::Result<RegistrationCase> loadInputs(CaseDocument document, const std::string& casePath, core::Messages& warnings,
                                          const ReadObserver& observe)
{
    RegistrationCase& values = document.values;
    if (auto read = readVesselInput(values, warnings, partOf(observe, 0.0, 0.9)); !read) {
        return read.error();
    }
    readScan(values, warnings);
    if (const auto read = loadView(document, casePath, warnings); !read) {
        return read.error();
    }
    dropUnknownBranches(values.auxiliaryBranchIds, *values.tree, "auxiliaryBranches", warnings);
    dropUnknownBranches(values.excludedBranchIds, *values.tree, "excludedBranches", warnings);
    dropUnknownBranches(values.hiddenBranchIds, *values.tree, "hiddenBranches", warnings);
    return std::move(document.values);
}

}   // namespace angiopose::io