#include "io/case/view_inputs.h"

#include "core/case_views.h"
#include "core/imaging/patient_match.h"
#include "io/angiogram_file.h"
#include "io/centerline2d_file.h"
#include "io/dicom/c_arm_tags.h"
#include "io/file_hash.h"
#include "io/subtraction_file.h"
#include "io/support/file_error.h"

#include <algorithm>
#include <iterator>

namespace angiopose::io {
namespace {

using core::RegistrationCase;

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

core::Status readImage(RegistrationCase& values, std::vector<std::string>& warnings)
{
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

/// Frame, geometry and the pose to start from.
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

core::Status loadView(CaseDocument& document, const std::string& casePath, std::vector<std::string>& warnings)
{
    if (const auto read = readImage(document.values, warnings); !read) {
        return read.error();
    }
    if (const auto completed = complete(document, warnings); !completed) {
        return fileError(casePath, completed.error().message);
    }
    if (const auto treated = treatRun(document); !treated) {
        return fileError(casePath, treated.error().message);
    }
    return core::Done{};
}

RegistrationCase loadOtherView(CaseDocument document, const RegistrationCase& first, const std::string& casePath,
                               std::vector<std::string>& warnings)
{
    RegistrationCase& values = document.values;
    values.tree = first.tree;
    values.scanIdentity = first.scanIdentity;
    if (const auto loaded = loadView(document, casePath, warnings); !loaded) {
        warnings.push_back("Another view is left out: " + loaded.error().message);
        values.angiogram.reset();
    }
    return core::viewOf(values);
}

}   // namespace angiopose::io