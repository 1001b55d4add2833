#include "app/files/opening.h"

#include "app/document/edit_case.h"
#include "app/files/open_controller.h"
#include "app/files/recent_cases.h"
#include "core/case/case_patients.h"
#include "core/case/case_views.h"
#include "core/vessel/tree_position.h"
#include "io/opening/assemble_case.h"
#include "io/opening/view_from_inputs.h"
#include "ui/actions/key_hint.h"
#include "ui/words/message_text.h"
#include "ui/words/number.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>

#include <algorithm>
#include <memory>
#include <utility>

namespace angiopose::app {
namespace {

struct NoteWords {
    Q_DECLARE_TR_FUNCTIONS(angiopose::app::OpenNotes)
};

/// Returns remarks on the opened files and on how they fit the case to which they now belong.
QStringList openNotes(const io::LoadedInputs& inputs, const core::Case& opened)
{
    QStringList notes;
    for (const core::Message& warning : inputs.warnings) {
        notes << ui::messageText(warning);
    }
    if (!inputs.loadedCase && inputs.vesselInput.unitMm > 0.0) {
        notes << NoteWords::tr("File unit: %1 mm, as selected.").arg(ui::briefNumber(inputs.vesselInput.unitMm, 6));
    }
    if (!inputs.loadedCase) {   // for a complete case file, the images were compared while loading
        for (const core::Message& mismatch : core::findMismatch(opened)) {
            notes << ui::messageText(mismatch);
        }
    }
    return notes;
}

/// Returns remarks on a scan opened with vessels from another file, which must be in the same patient coordinates.
QStringList scanNotes(const io::LoadedInputs& inputs, const core::Case& opened)
{
    if (inputs.volume && !opened.vessels.tree) {
        return {NoteWords::tr("No vessels have been traced in the scan yet. Place a seed or set the threshold in the "
                              "slices (%1), then trace.")
                    .arg(ui::keyOf(ui::Command::SlicesLarge))};
    }
    const bool isBeside = inputs.volume && !inputs.tree && opened.vessels.tree;
    return isBeside && !io::isInsideScan(inputs.volume->geometry, *opened.vessels.tree)
               ? QStringList(NoteWords::tr("The vessels lie outside this scan: it may be a different scan or use a "
                                           "different coordinate system."))
               : QStringList();
}

QStringList replaceCase(CaseDocument& document, const core::Case& newCase, const Opening& opening)
{
    const QString path = opening.inputs.loadedCase ? opening.original.value_or(opening.paths.front()) : QString();
    document.replace(newCase, path);
    if (!path.isEmpty()) {
        rememberCase(path);
    }
    if (opening.original || !opening.inputs.moved.empty()) {
        document.markUnsaved();   // the open case differs from its file
    }
    return openNotes(opening.inputs, document.current());
}

QStringList joinCase(CaseDocument& document, const core::Case& newCase, const Opening& opening)
{
    if (document.isEmpty() &&
        document.undoStack().count() == 0) {   // otherwise, replacing would discard a mask painted on a scan alone
        document.replace(newCase, {});
    } else {
        document.push(addInputs(document, newCase,
                                [names = namesOf(opening.paths)] { return OpenController::tr("Open %1").arg(names); }));
    }
    return openNotes(opening.inputs, document.current()) + scanNotes(opening.inputs, document.current());
}

QStringList addView(CaseDocument& document, const core::Case& newCase, const Opening& opening)
{
    const QStringList notes = openNotes(opening.inputs, core::withShownView(newCase, newCase.views.size() - 1));
    document.push(std::make_unique<ChangeViews>(
        document, ChangeViews::valuesOf(newCase),
        [names = namesOf(opening.paths)] { return OpenController::tr("Add view %1").arg(names); }));
    return notes +
           QStringList{OpenController::tr("View added. To show it, click its entry in the strip above the image.")};
}

constexpr double farFromVesselsMm = 50.0;

/// Returns the camera from the file with the image size of the view.
core::ProjectionCamera incomingCamera(const core::View& view, core::ProjectionCamera camera)
{
    camera.width = view.angiogram->width();
    camera.height = view.angiogram->height();
    return camera;
}

QString whyCameraDoesNotFit(const core::View& view, const core::ProjectionCamera& camera)
{
    const int width = view.angiogram->width(), height = view.angiogram->height();
    if (!io::fitsImage(camera, width, height)) {
        return OpenController::tr(
                   "The pose belongs to an image of %1 × %2 px, but the angiogram is %3 × %4 px. Open the pose that "
                   "belongs to this angiogram.")
            .arg(camera.width)
            .arg(camera.height)
            .arg(width)
            .arg(height);
    }
    const auto own = core::cameraOf(view);
    if (own && (own.value().fx < 0.0) != (camera.fx < 0.0)) {
        return OpenController::tr(
            "The camera stored with the pose is mirrored relative to the angiogram: one is viewed from the detector, "
            "the other from the source. Mirror the image, or change the viewing side in the geometry panel.");
    }
    return {};
}

bool liesBehindSource(const core::Case& open, const core::RigidTransform& pose)
{
    return (pose * core::centroidInPatient(*open.vessels.tree)).z() < core::minProjectableDepthMm;
}

/// For the pose of a result, lists the inputs of its registration that differ from those of the case.
QStringList notesOnInputs(const core::Case& open, const io::PoseWithCamera& pose)
{
    const auto differ = [](const std::string& theirs, const std::string& ours) {
        return !theirs.empty() && !ours.empty() && theirs != ours;
    };
    QStringList notes;
    if (differ(pose.vesselSha256, open.vessels.file.sha256)) {
        notes << OpenController::tr("The pose was registered with different vessels.");
    }
    if (differ(pose.imageSha256, open.shown().imageFile.sha256)) {
        notes << OpenController::tr("The pose was registered to a different angiogram.");
    }
    return notes;
}

}   // namespace

QString namesOf(const QStringList& paths)
{
    QStringList names;
    for (const QString& path : paths) {
        names << QFileInfo(QDir::cleanPath(path)).fileName();
    }
    return names.join(QStringLiteral(", "));
}

bool isAnotherView(const core::Case& open, const io::LoadedInputs& inputs)
{
    const bool isNew = inputs.imageFile.path != open.shown().imageFile.path;
    return inputs.angiogram && !inputs.tree && !inputs.loadedCase && open.vessels.tree && open.shown().angiogram &&
           isNew;
}

core::Result<core::Case> mergeIntoCase(const core::Case& open, const Opening& opening)
{
    const io::LoadedInputs& inputs = opening.inputs;
    core::Case newCase = open;
    if (opening.mode == Opening::Mode::Replace) {
        newCase = inputs.loadedCase ? *inputs.loadedCase : io::assembleCase({}, inputs);
    } else if (opening.mode == Opening::Mode::Join) {
        newCase = io::assembleCase(open, inputs);
    } else {
        auto added = io::viewFromInputs(open, inputs, opening.paths.front().toStdString());
        if (!added) {
            return added.error();
        }
        newCase.views.push_back(std::move(added).value());
    }
    for (core::View& view : newCase.views) {
        view.isSamePatient = opening.isSamePatient.value_or(view.isSamePatient);
    }
    return newCase;
}

core::Result<QStringList> addToCase(CaseDocument& document, const Opening& opening)
{
    const auto newCase = mergeIntoCase(document.current(), opening);
    if (!newCase) {
        return newCase.error();
    }
    switch (opening.mode) {
        case Opening::Mode::Replace:
            return replaceCase(document, newCase.value(), opening);
        case Opening::Mode::AddView:
            return addView(document, newCase.value(), opening);
        case Opening::Mode::Join:
            break;
    }
    return joinCase(document, newCase.value(), opening);
}

PoseCompatibility checkPoseCompatibility(const core::Case& open, const io::PoseWithCamera& pose)
{
    PoseCompatibility fit;
    const core::View& view = open.shown();
    if (!open.vessels.tree || !view.angiogram) {
        fit.refusal = OpenController::tr(
            "A pose can be opened only in a case. Open vessels and an angiogram first, then the pose.");
        return fit;
    }
    if (liesBehindSource(open, pose.cameraFromPatient)) {
        fit.refusal = OpenController::tr(
            "At this pose, the vessels lie behind the X-ray source. The pose may belong to another patient, or it may "
            "map camera coordinates to patient coordinates; in the latter case, invert the pose.");
        return fit;
    }
    if (pose.camera) {
        fit.refusal = whyCameraDoesNotFit(view, *pose.camera);
        const auto own = core::cameraOf(view);
        fit.isOtherCamera = own && !io::isSameCamera(own.value(), incomingCamera(view, *pose.camera));
    }
    fit.notes = notesOnInputs(open, pose);
    return fit;
}

QStringList applyPose(CaseDocument& document, const io::PoseWithCamera& pose, IncomingCamera camera,
                      const QString& name)
{
    const core::View& view = document.current().shown();
    QStringList notes = checkPoseCompatibility(document.current(), pose).notes;
    core::ViewGeometry geometry = view.geometry;
    const bool isMissing = !core::cameraOf(view);
    if (pose.camera && (camera == IncomingCamera::OfPose || isMissing)) {
        geometry.cameraOverride = incomingCamera(view, *pose.camera);
        notes << OpenController::tr(
            "The camera stored with the pose is now in use. You can revert this in the geometry panel.");
    }
    document.push(std::make_unique<ChangeGeometry>(
        document, ChangeGeometry::Values{std::move(geometry), pose.cameraFromPatient, std::nullopt, {}},
        [name] { return OpenController::tr("Open pose %1").arg(name); }));
    return notes;
}

core::Result<QStringList> addTargetPoints(CaseDocument& document, const std::vector<io::Fiducial>& points,
                                          const QString& name)
{
    const core::Case& open = document.current();
    if (!open.vessels.tree) {
        return core::Error(core::Message::verbatim(
            OpenController::tr(
                "Points can be opened only in a case with vessels. Open the vessels first, then the points.")
                .toStdString()));
    }
    std::vector<core::VesselMark> marks = open.vessels.marks;
    bool isNear = false;
    for (const io::Fiducial& point : points) {
        core::VesselMark mark;
        mark.id = core::nextMarkId(marks);
        mark.name = point.name.empty() ? std::to_string(mark.id) : point.name;
        mark.pointInPatient = point.pointInPatient;
        marks.push_back(std::move(mark));
        const auto nearest = core::nearestPointOnTree(*open.vessels.tree, point.pointInPatient);
        isNear = isNear || (nearest && (*nearest - point.pointInPatient).norm() < farFromVesselsMm);
    }
    QStringList notes{OpenController::tr("Target points added: %1.").arg(points.size())};
    if (!isNear) {
        notes << OpenController::tr(
            "None of the target points is near the vessels. The points may belong to another patient or use a "
            "different coordinate system.");
    }
    document.push(std::make_unique<ChangeMarks>(document, ChangeMarks::Values{std::move(marks)},
                                                [name] { return OpenController::tr("Open points %1").arg(name); }));
    return notes;
}

}   // namespace angiopose::app
