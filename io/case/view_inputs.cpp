#include "io/case/view_inputs.h"

#include "core/case/initial_pose.h"
#include "io/angiogram_file.h"
#include "io/centerline2d_file.h"
#include "io/dicom/c_arm_tags.h"
#include "io/file_hash.h"
#include "io/messages/messages.h"
#include "io/subtraction_file.h"
#include "io/support/file_error.h"

#include <algorithm>
#include <iterator>
#include <optional>

namespace angiopose::io {
namespace {

using core::View;

/// Applies the subtraction settings of the case to the plan from the image header.
core::SubtractionPlan completed(const SubtractionOverrides& keys, core::SubtractionPlan plan)
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

core::Status treatRun(View& view, const ViewNotes& notes)
{
    const auto header = readSubtractionPlan(view.imageFile.path);
    if (!header) {
        return header.error();
    }
    view.headerPlan = header.value();
    view.processing.plan = notes.subtraction ? completed(*notes.subtraction, header.value()) : header.value();
    if (!view.processing.changesFrames()) {
        return core::Done{};
    }
    auto treated = core::processRun(*view.angiogram, view.processing);
    if (!treated) {
        return treated.error().about("angiogram.subtraction");
    }
    view.storedRun = view.angiogram;
    view.angiogram = std::make_shared<const core::Angiogram>(std::move(treated).value());
    return core::Done{};
}

/// Reads the registration target and the catheters and guidewires that are excluded from it.
core::Status readTarget(View& view, const ViewNotes& notes)
{
    auto read = readCenterline2d(view.target.file.path);
    if (!read) {
        return read.error();
    }
    const std::vector<int> none;
    core::SeparatedCurves apart =
        core::separateDevices(read.value(), view.target.editedFrame ? notes.deviceCurveIds : none);
    view.target.centerline = std::make_shared<const core::Centerline2d>(std::move(apart.vessels));
    if (!apart.devices.curves.empty()) {
        view.target.devices = std::make_shared<const core::Centerline2d>(std::move(apart.devices));
    }
    return core::Done{};
}

core::Status readImage(View& view, const ViewNotes& notes, core::Messages& warnings, PeakFrameSearch peak)
{
    auto angiogram = io::readAngiogram(view.imageFile.path, notes.hasFrame ? peak : PeakFrameSearch::Enabled);
    if (!angiogram) {
        return angiogram.error();
    }
    view.angiogram = std::make_shared<const core::Angiogram>(std::move(angiogram).value());
    if (!view.target.file.path.empty()) {
        if (auto target = readTarget(view, notes); !target) {
            return target;
        }
    }
    for (core::InputFile* file : {&view.imageFile, &view.target.file}) {
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
void fillFrom(core::SourcedValue<Value>& value, const core::SourcedValue<Value>& header)
{
    if (!value.value) {
        value = header;
    }
}

/// Returns an inconsistency that can be detected only after loading the inputs; nullopt if there is none.
std::optional<core::Message> findMisfit(const View& view)
{
    const core::Angiogram& angiogram = *view.angiogram;
    if (view.frame >= angiogram.frameCount()) {
        return messages::caseFrameMissing(view.frame, angiogram.frameCount() - 1).about("angiogram.frame");
    }
    const auto& camera = view.geometry.cameraOverride;
    if (camera && (camera->width != angiogram.width() || camera->height != angiogram.height())) {
        return messages::caseCameraOfOtherImage(camera->width, camera->height, angiogram.width(), angiogram.height())
            .about("geometry.camera");
    }
    return {};
}

/// Sets the frame, the geometry and the initial pose of a view once its image is loaded.
core::Status complete(View& view, const ViewNotes& notes, const core::Vessels& vessels, core::Messages& warnings)
{
    const core::Angiogram& angiogram = *view.angiogram;
    view.frame = notes.hasFrame ? view.frame : angiogram.suggestedFrame;
    if (view.result && !view.result->provenance.frame) {   // older case files do not store the frame of the result
        view.result->provenance.frame = view.frame;
    }
    if (const auto misfit = findMisfit(view)) {
        return core::Error(*misfit);
    }
    if (!notes.sopInstanceUid.empty() && notes.sopInstanceUid != angiogram.identity.sopInstanceUid) {
        warnings.push_back(messages::caseOtherImage().about(view.imageFile.path));
    }
    const bool isSpacingGiven =
        view.geometry.cameraOverride || view.geometry.cArm.columnSpacingMm.origin == core::Origin::User;
    std::copy_if(angiogram.warnings.begin(), angiogram.warnings.end(), std::back_inserter(warnings),
                 [&](const core::Message& warning) { return !isSpacingGiven || !isMissingSpacingWarning(warning); });
    fillFromHeader(view.geometry.cArm, angiogram.cArm);
    if (!notes.hasCurrentPose) {
        const auto start = core::initialPoseOf(view, vessels);
        if (!start) {
            return core::Error(messages::caseNoInitialPose(start.error().message).about("pose.initial"));
        }
        view.cameraFromPatient = start.value();
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
        warnings.push_back(messages::caseFileChanged().about(file.path));
    }
    file.sha256 = std::move(hash).value();
    return core::Done{};
}

void fillFromHeader(core::CArm& cArm, const core::CArm& header)
{
    fillFrom(cArm.sourceToDetectorMm, header.sourceToDetectorMm);
    fillFrom(cArm.sourceToIsocenterMm, header.sourceToIsocenterMm);
    fillFrom(cArm.sourceToObjectMm, header.sourceToObjectMm);
    assumeIsocenter(cArm);
    fillFrom(cArm.columnSpacingMm, header.columnSpacingMm);
    fillFrom(cArm.rowSpacingMm, header.rowSpacingMm);
    fillFrom(cArm.primaryAngleDeg, header.primaryAngleDeg);
    fillFrom(cArm.secondaryAngleDeg, header.secondaryAngleDeg);
    fillFrom(cArm.rollDeg, header.rollDeg);
    fillFrom(cArm.principalPointPx, header.principalPointPx);
    fillFrom(cArm.mirrored, header.mirrored);
    fillFrom(cArm.isocenterInPatientMm, header.isocenterInPatientMm);
}

core::Status loadView(View& view, const ViewNotes& notes, const core::Vessels& vessels, const std::string& casePath,
                      core::Messages& warnings, PeakFrameSearch peak)
{
    if (const auto read = readImage(view, notes, warnings, peak); !read) {
        return read.error();
    }
    if (const auto completed = complete(view, notes, vessels, warnings); !completed) {
        return fileError(casePath, completed.error());
    }
    if (const auto treated = treatRun(view, notes); !treated) {
        return fileError(casePath, treated.error());
    }
    return core::Done{};
}

void loadOtherView(View& view, const ViewNotes& notes, const core::Vessels& vessels, const std::string& casePath,
                   core::Messages& warnings, PeakFrameSearch peak)
{
    if (const auto loaded = loadView(view, notes, vessels, casePath, warnings, peak); !loaded) {
        warnings.push_back(messages::caseViewLeftOut(loaded.error().message));
        view.angiogram.reset();
    }
}

}   // namespace angiopose::io
