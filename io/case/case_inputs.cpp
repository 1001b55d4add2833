#include "io/case/case_inputs.h"

#include "core/imaging/patient_match.h"
#include "io/angiogram_file.h"
#include "io/centerline2d_file.h"
#include "io/dicom/c_arm_tags.h"
#include "io/file_hash.h"
#include "io/subtraction_file.h"
#include "io/support/file_error.h"
#include "io/vessel_input_file.h"
#include "io/volume_file.h"

#include <algorithm>
#include <filesystem>
#include <iterator>

namespace io {
namespace {

namespace fs = std::filesystem;
using core::RegistrationCase;

void makeAbsolute(core::InputFile& file, const fs::path& folder)
{
    if (!file.path.empty()) {
        file.path = (folder / fs::path(file.path)).lexically_normal().string();
    }
}

/// Notes the hash of what was read; warns where the case expected something else.
core::Status checkHash(core::InputFile& file, core::Result<std::string> hash, std::vector<std::string>& warnings)
{
    if (!hash) {
        return hash.error();
    }
    if (!file.sha256.empty() && file.sha256 != hash.value()) {
        warnings.push_back(file.path +
                           ": the file has changed since the case was saved. Check that it is the right one.");
    }
    file.sha256 = std::move(hash).value();
    return core::Done{};
}

/// The scan that vessels of another origin lie in: good to have, but the case opens without it.
void readScan(RegistrationCase& values, std::vector<std::string>& warnings)
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
void readOrigin(RegistrationCase& values, std::vector<std::string>& warnings, const ReadObserver& observe)
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
        warnings.push_back(checked.error().message + " The edited vessels are in the case; it opens without the file.");
    }
}

core::Status readVesselInput(RegistrationCase& values, std::vector<std::string>& warnings, const ReadObserver& observe)
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

/// The case's own keys win over the header's.
core::SubtractionPlan completed(const SubtractionKeys& keys, core::SubtractionPlan plan)
{
    if (keys.maskFrames || keys.interval) {
        plan.maskFrames = keys.maskFrames.value_or(std::vector<int>());
        plan.interval = keys.interval;
    }
    if (keys.maskShiftPx || keys.isShiftAutomatic) {
        plan.maskShiftPx = keys.maskShiftPx;
    }
    plan.relation = keys.relation.value_or(plan.relation);
    return plan;
}

core::Status treatRun(CaseDocument& document)
{
    RegistrationCase& values = document.values;
    const auto header = readSubtractionPlan(values.imageFile.path);
    if (!header) {
        return header.error();
    }
    values.headerPlan = header.value();
    values.treatment.plan = document.subtraction ? completed(*document.subtraction, header.value()) : header.value();
    if (!values.treatment.changesFrames()) {
        return core::Done{};
    }
    auto treated = core::treatedRun(*values.angiogram, values.treatment);
    if (!treated) {
        return core::Error{"angiogram.subtraction: " + treated.error().message};
    }
    values.storedRun = values.angiogram;
    values.angiogram = std::make_shared<const core::Angiogram>(std::move(treated).value());
    return core::Done{};
}

core::Status readInputs(RegistrationCase& values, std::vector<std::string>& warnings, const ReadObserver& observe)
{
    if (auto read = readVesselInput(values, warnings, partOf(observe, 0.0, 0.9)); !read) {
        return read;
    }
    readScan(values, warnings);
    auto angiogram = io::readAngiogram(values.imageFile.path);
    if (!angiogram) {
        return angiogram.error();
    }
    values.angiogram = std::make_shared<const core::Angiogram>(std::move(angiogram).value());
    if (!values.targetFile.path.empty()) {
        auto target = readCenterline2d(values.targetFile.path);
        if (!target) {
            return target.error();
        }
        values.givenTarget = std::make_shared<const core::Centerline2d>(std::move(target).value());
    }
    for (core::InputFile* file : {&values.imageFile, &values.targetFile}) {
        if (file->path.empty()) {
            continue;
        }
        if (auto checked = checkHash(*file, sha256OfFile(file->path), warnings); !checked) {
            return checked;
        }
    }
    return core::Done{};
}

template <class Value>
void fillFrom(core::Sourced<Value>& value, const core::Sourced<Value>& header)
{
    if (!value.value) {
        value = header;
    }
}

void dropUnknownBranches(std::vector<int>& ids, const core::VesselTree& tree, const char* key,
                         std::vector<std::string>& warnings)
{
    std::erase_if(ids, [&](int id) {
        const bool isUnknown = tree.find(id) == nullptr;
        if (isUnknown) {
            warnings.push_back(std::string("vessel.") + key + ": the tree has no branch " + std::to_string(id) +
                               "; it is left out.");
        }
        return isUnknown;
    });
}

/// What only shows once the inputs are there; empty when all fits.
std::string findMisfit(const RegistrationCase& values)
{
    const core::Angiogram& angiogram = *values.angiogram;
    if (values.frame >= angiogram.frameCount()) {
        return "angiogram.frame: " + std::to_string(values.frame) + " does not exist. The image has frames 0 to " +
               std::to_string(angiogram.frameCount() - 1) + ".";
    }
    const auto& camera = values.cameraOverride;
    if (camera && (camera->width != angiogram.width() || camera->height != angiogram.height())) {
        return "geometry.camera: it is for an image of " + std::to_string(camera->width) + " x " +
               std::to_string(camera->height) + " pixels, but the angiogram has " + std::to_string(angiogram.width()) +
               " x " + std::to_string(angiogram.height()) + ". Give the camera of this image.";
    }
    return {};
}

/// Completes a loaded case: frame, geometry, branches and the pose to start from.
core::Status complete(CaseDocument& document, std::vector<std::string>& warnings)
{
    RegistrationCase& values = document.values;
    const core::Angiogram& angiogram = *values.angiogram;
    values.frame = document.hasFrame ? values.frame : angiogram.suggestedFrame;
    if (const std::string misfit = findMisfit(values); !misfit.empty()) {
        return core::Error{misfit};
    }
    if (!document.sopInstanceUid.empty() && document.sopInstanceUid != angiogram.identity.sopInstanceUid) {
        warnings.push_back(values.imageFile.path + ": this is another DICOM image than the one the case was made for.");
    }
    const bool isSpacingGiven = values.cameraOverride || values.cArm.columnSpacingMm.origin == core::Origin::User;
    std::copy_if(angiogram.warnings.begin(), angiogram.warnings.end(), std::back_inserter(warnings),
                 [&](const std::string& warning) { return !isSpacingGiven || !isAboutMissingSpacing(warning); });
    if (std::string mismatch = core::findMismatch(values.scanIdentity, angiogram.identity); !mismatch.empty()) {
        warnings.push_back(std::move(mismatch));
    }
    fillFromHeader(values.cArm, angiogram.cArm);
    dropUnknownBranches(values.auxiliaryBranchIds, *values.tree, "auxiliaryBranches", warnings);
    dropUnknownBranches(values.excludedBranchIds, *values.tree, "excludedBranches", warnings);
    dropUnknownBranches(values.hiddenBranchIds, *values.tree, "hiddenBranches", warnings);
    if (!document.hasCurrentPose) {
        const auto start = core::startPoseOf(values);
        if (!start) {
            return core::Error{"pose.initial: it is missing, and the angles do not give a start pose. " +
                               start.error().message};
        }
        values.cameraFromPatient = start.value();
    }
    return core::Done{};
}

}   // namespace

void fillFromHeader(core::CArm& cArm, const core::CArm& header)
{
    fillFrom(cArm.sourceToDetectorMm, header.sourceToDetectorMm);
    fillFrom(cArm.sourceToPatientMm, header.sourceToPatientMm);
    fillFrom(cArm.columnSpacingMm, header.columnSpacingMm);
    fillFrom(cArm.rowSpacingMm, header.rowSpacingMm);
    fillFrom(cArm.primaryAngleDeg, header.primaryAngleDeg);
    fillFrom(cArm.secondaryAngleDeg, header.secondaryAngleDeg);
    fillFrom(cArm.rollDeg, header.rollDeg);
    fillFrom(cArm.principalPointPx, header.principalPointPx);
    fillFrom(cArm.mirrored, header.mirrored);
    fillFrom(cArm.isocentreInPatientMm, header.isocentreInPatientMm);
}

void makePathsAbsolute(RegistrationCase& values, const std::string& casePath)
{
    const fs::path folder = fs::absolute(casePath).parent_path();
    makeAbsolute(values.centerlineFile, folder);
    makeAbsolute(values.scanFile, folder);
    makeAbsolute(values.imageFile, folder);
    makeAbsolute(values.targetFile, folder);
    for (core::InputFile& view : values.otherViews) {
        makeAbsolute(view, folder);
    }
}

core::Result<RegistrationCase> loadInputs(CaseDocument document, const std::string& casePath,
                                          std::vector<std::string>& warnings, const ReadObserver& observe)
{
    if (const auto read = readInputs(document.values, warnings, observe); !read) {
        return read.error();
    }
    if (const auto completed = complete(document, warnings); !completed) {
        return fileError(casePath, completed.error().message);
    }
    if (const auto treated = treatRun(document); !treated) {
        return fileError(casePath, treated.error().message);
    }
    return std::move(document.values);
}

}   // namespace io
