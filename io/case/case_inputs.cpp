#include "io/case/case_inputs.h"

#include "core/imaging/patient_match.h"
#include "io/angiogram_file.h"
#include "io/centerline2d_file.h"
#include "io/file_hash.h"
#include "io/support/file_error.h"
#include "io/vessel_input_file.h"

#include <filesystem>

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

core::Status readVesselInput(RegistrationCase& values, std::vector<std::string>& warnings, const ReadObserver& observe)
{
    auto read = readVessels(values.centerlineFile.path, values.vesselInput, observe);
    if (!read) {
        return read.error();
    }
    LoadedVessels vessels = std::move(read).value();
    values.vesselInput = vessels.input;
    values.volume = vessels.volume;
    values.scanIdentity = vessels.identity;
    values.tree = std::make_shared<const core::VesselTree>(std::move(vessels.tree));
    warnings.insert(warnings.end(), vessels.warnings.begin(), vessels.warnings.end());
    return checkHash(values.centerlineFile, sha256OfVesselInput(values.centerlineFile.path, values.vesselInput),
                     warnings);
}

core::Status readInputs(RegistrationCase& values, std::vector<std::string>& warnings, const ReadObserver& observe)
{
    if (auto read = readVesselInput(values, warnings, partOf(observe, 0.0, 0.9)); !read) {
        return read;
    }
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

/// The case's own values win over the header's.
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
    warnings.insert(warnings.end(), angiogram.warnings.begin(), angiogram.warnings.end());
    if (std::string mismatch = core::findPatientMismatch(values.scanIdentity, angiogram.identity); !mismatch.empty()) {
        warnings.push_back(std::move(mismatch));
    }
    fillFromHeader(values.cArm, angiogram.cArm);
    dropUnknownBranches(values.auxiliaryBranchIds, *values.tree, "auxiliaryBranches", warnings);
    dropUnknownBranches(values.excludedBranchIds, *values.tree, "excludedBranches", warnings);
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

void makePathsAbsolute(RegistrationCase& values, const std::string& casePath)
{
    const fs::path folder = fs::absolute(casePath).parent_path();
    makeAbsolute(values.centerlineFile, folder);
    makeAbsolute(values.imageFile, folder);
    makeAbsolute(values.targetFile, folder);
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
    return std::move(document.values);
}

}   // namespace io
