#include "io/case/view_inputs.h"

#include "core/case_views.h"
#include "core/imaging/patient_match.h"
#include "io/angiogram_file.h"
#include "io/centerline2d_file.h"
#include "io/dicom/c_arm_tags.h"
#include "io/file_hash.h"
#include "io/messages/says.h"
#include "io/subtraction_file.h"
#include "io/support/file_error.h"

#include <algorithm>
#include <iterator>
#include <optional>

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
        return treated.error().about("angiogram.subtraction");
    }
    values.storedRun = values.angiogram;
    values.angiogram = std::make_shared<const core::Angiogram>(std::move(treated).value());
    return core::Done{};
}

core::Status readImage(RegistrationCase& values, core::Messages& warnings)
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

/// What only shows once the inputs are there.
std::optional<core::Message> findMisfit(const RegistrationCase& values)
{
    const core::Angiogram& angiogram = *values.angiogram;
    if (values.frame >= angiogram.frameCount()) {
        return says::caseFrameMissing(values.frame, angiogram.frameCount() - 1).about("angiogram.frame");
    }
    const auto& camera = values.cameraOverride;
    if (camera && (camera->width != angiogram.width() || camera->height != angiogram.height())) {
        return says::caseCameraOfOtherImage(camera->width, camera->height, angiogram.width(), angiogram.height())
            .about("geometry.camera");
    }
    return {};
}

/// Frame, geometry and the pose to start from.
core::Status complete(CaseDocument& document, core::Messages& warnings)
{
    RegistrationCase& values = document.values;
    const core::Angiogram& angiogram = *values.angiogram;
    values.frame = document.hasFrame ? values.frame : angiogram.suggestedFrame;
    if (const auto misfit = findMisfit(values)) {
        return core::Error(*misfit);
    }
    if (!document.sopInstanceUid.empty() && document.sopInstanceUid != angiogram.identity.sopInstanceUid) {
        warnings.push_back(says::caseOtherImage().about(values.imageFile.path));
    }
    const bool isSpacingGiven = values.cameraOverride || values.cArm.columnSpacingMm.origin == core::Origin::User;
    std::copy_if(angiogram.warnings.begin(), angiogram.warnings.end(), std::back_inserter(warnings),
                 [&](const core::Message& warning) { return !isSpacingGiven || !isAboutMissingSpacing(warning); });
    for (const core::Message& mismatch : core::findMismatch(values.scanIdentity, angiogram.identity)) {
        warnings.push_back(mismatch);
    }
    fillFromHeader(values.cArm, angiogram.cArm);
    if (!document.hasCurrentPose) {
        const auto start = core::startPoseOf(values);
        if (!start) {
            return core::Error(says::caseNoStartPose(start.error().message).about("pose.initial"));
        }
        values.cameraFromPatient = start.value();
    }
    return core::Done{};
}

}   // namespace

core::Status checkHash(core::InputFile& file, core::Result<std::string> hash, core::Messages& warnings)
{
    if (!hash) {
        return hash.error();
    }
    if (!file.sha256.empty() && file.sha256 != hash.value()) {
        warnings.push_back(says::caseFileChanged().about(file.path));
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

core::Status loadView(CaseDocument& document, const std::string& casePath, core::Messages& warnings)
{
    if (const auto read = readImage(document.values, warnings); !read) {
        return read.error();
    }
    if (const auto completed = complete(document, warnings); !completed) {
        return fileError(casePath, completed.error());
    }
    if (const auto treated = treatRun(document); !treated) {
        return fileError(casePath, treated.error());
    }
    return core::Done{};
}

RegistrationCase loadOtherView(CaseDocument document, const RegistrationCase& first, const std::string& casePath,
                               core::Messages& warnings)
{
    RegistrationCase& values = document.values;
    values.tree = first.tree;
    values.scanIdentity = first.scanIdentity;
    if (const auto loaded = loadView(document, casePath, warnings); !loaded) {
        warnings.push_back(says::caseViewLeftOut(loaded.error().message));
        values.angiogram.reset();
    }
    return core::viewOf(values);
}

}   // namespace angiopose::io