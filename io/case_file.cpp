#include "io/case_file.h"

#include "io/angiogram_file.h"
#include "io/case/case_document.h"
#include "io/case/case_schema.h"
#include "io/centerline2d_file.h"
#include "io/file_hash.h"
#include "io/support/atomic_file.h"
#include "io/support/file_error.h"
#include "io/support/input_bytes.h"
#include "io/support/json_text.h"
#include "io/vessel_tree_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <filesystem>

namespace io {
namespace {

namespace fs = std::filesystem;
using core::RegistrationCase;

constexpr std::size_t maxCaseBytes = 16 << 20;

/// The text of a case file that is JSON.
core::Result<std::string> readCaseText(const std::string& path)
{
    const auto input = openInput(path);
    if (!input) {
        return input.error();
    }
    const std::string_view content = input.value().view();
    if (content.size() > maxCaseBytes) {
        return fileError(path, "it is too large for a case file. Choose an .angiopose file.");
    }
    const std::string_view found = describeContent(content);
    if (!found.empty() && found != "a JSON file") {
        return fileError(path, "this is " + std::string(found) + ", not a case. Choose an .angiopose file.");
    }
    if (const auto valid = checkJson(content, path); !valid) {
        return valid.error();
    }
    return std::string(content);
}

/// Content, and everything wrong with it.
CaseDocument examine(const std::string& text)
{
    CaseDocument document;
    document.problems = findSchemaProblems(text);
    return document.problems.empty() ? parseCaseDocument(text) : document;
}

void makeAbsolute(core::InputFile& file, const fs::path& folder)
{
    if (!file.path.empty()) {
        file.path = (folder / fs::path(file.path)).lexically_normal().string();
    }
}

void makeAbsolute(RegistrationCase& values, const std::string& casePath)
{
    const fs::path folder = fs::absolute(casePath).parent_path();
    makeAbsolute(values.centerlineFile, folder);
    makeAbsolute(values.imageFile, folder);
    makeAbsolute(values.targetFile, folder);
}

/// Notes the hash of what was read; warns where the case expected something else.
core::Status checkHash(core::InputFile& file, std::vector<std::string>& warnings)
{
    auto hash = sha256OfFile(file.path);
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

core::Status loadInputs(RegistrationCase& values, std::vector<std::string>& warnings)
{
    auto tree = readVesselTree(values.centerlineFile.path);
    if (!tree) {
        return tree.error();
    }
    values.tree = std::make_shared<const core::VesselTree>(std::move(tree).value());
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
    for (core::InputFile* file : {&values.centerlineFile, &values.imageFile, &values.targetFile}) {
        if (file->path.empty()) {
            continue;
        }
        if (const auto checked = checkHash(*file, warnings); !checked) {
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

/// The input that `path` is, if any.
std::string inputAt(const RegistrationCase& registrationCase, const std::string& path)
{
    for (const core::InputFile* file :
         {&registrationCase.centerlineFile, &registrationCase.imageFile, &registrationCase.targetFile}) {
        std::error_code absent;
        if (!file->path.empty() && fs::equivalent(file->path, path, absent)) {
            return file->path;
        }
    }
    return {};
}

/// What cannot be written as a case that loads again; empty when all can.
std::string findUnsavable(const RegistrationCase& values)
{
    if (values.centerlineFile.path.empty() || values.imageFile.path.empty()) {
        return "a case needs a vessel tree and an angiogram. Open both before saving.";
    }
    if (!core::isRigid(values.cameraFromPatient) ||
        (values.hasInitialPose && !core::isRigid(values.initialCameraFromPatient))) {
        return "the pose is not a rigid motion of finite numbers. Reset the pose before saving.";
    }
    return {};
}

}   // namespace

core::Result<RegistrationCase> loadCase(const std::string& path, std::vector<std::string>& warnings)
{
    const auto text = readCaseText(path);
    if (!text) {
        return text.error();
    }
    try {
        CaseDocument document = examine(text.value());
        if (!document.problems.empty()) {
            return fileError(path, document.problems.front());
        }
        makeAbsolute(document.values, path);
        if (const auto loaded = loadInputs(document.values, warnings); !loaded) {
            return loaded.error();
        }
        if (const auto completed = complete(document, warnings); !completed) {
            return fileError(path, completed.error().message);
        }
        return std::move(document.values);
    } catch (const std::exception&) {   // a value the schema let through
        return fileError(path, "a value in it has the wrong kind. Compare it with the published schema.");
    }
}

core::Result<std::vector<std::string>> validateCase(const std::string& path)
{
    const auto text = readCaseText(path);
    if (!text) {
        return text.error();
    }
    try {
        CaseDocument document = examine(text.value());
        makeAbsolute(document.values, path);
        for (const core::InputFile* file :
             {&document.values.centerlineFile, &document.values.imageFile, &document.values.targetFile}) {
            if (file->path.empty()) {
                continue;
            }
            if (const auto input = openInput(file->path); !input) {
                document.problems.push_back(input.error().message);
            }
        }
        return std::move(document.problems);
    } catch (const std::exception&) {
        return fileError(path, "a value in it has the wrong kind. Compare it with the published schema.");
    }
}

core::Status saveCase(const RegistrationCase& registrationCase, const std::string& path)
{
    if (const std::string input = inputAt(registrationCase, path); !input.empty()) {
        return fileError(path, "this is an input of the case and will not be overwritten. Choose another name.");
    }
    if (const std::string unsavable = findUnsavable(registrationCase); !unsavable.empty()) {
        return fileError(path, unsavable);
    }
    RegistrationCase hashed = registrationCase;
    for (core::InputFile* file : {&hashed.centerlineFile, &hashed.imageFile, &hashed.targetFile}) {
        if (!file->path.empty() && file->sha256.empty()) {
            auto hash = sha256OfFile(file->path);
            file->sha256 = hash ? std::move(hash).value() : std::string();
        }
    }
    try {
        const fs::path folder = fs::weakly_canonical(fs::absolute(path).parent_path());
        return writeAtomically(path, caseDocumentText(hashed, folder));
    } catch (const std::exception&) {   // JSON is UTF-8, file names need not be
        return fileError(path, "a file name or a text in the case is not UTF-8. Rename the file.");
    }
}

}   // namespace io
