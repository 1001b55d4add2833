#include "app/files/open_controller.h"

#include "app/files/recent_cases.h"
#include "app/preferences/settings.h"
#include "core/case/case_patients.h"
#include "io/opening/assemble_case.h"
#include "ui/words/message_text.h"

#include <QFileInfo>

#include <algorithm>
#include <utility>

namespace angiopose::app {
namespace {

/// Lists recently used folders.
std::vector<std::string> foldersInUse()
{
    QStringList folders;
    for (const QString& path : recentCases()) {
        folders << QFileInfo(path).absolutePath();
    }
    if (const QString last = settings::lastFolder.read(); !last.isEmpty()) {
        folders << last;
    }
    folders.removeDuplicates();
    std::vector<std::string> places;
    for (const QString& folder : folders) {
        places.push_back(folder.toStdString());
    }
    return places;
}

}   // namespace

OpenController::OpenController(CaseDocument& document, QObject* parent) : QObject(parent), document_(document) {}

void OpenController::open(const QStringList& paths)
{
    originalPath_.reset();
    opensAsView_ = false;
    furtherRuns_.clear();
    io::OpenHints hints{{}, {}, foldersInUse()};
    hints.scanUse = scanUse();
    hints.offersStudies = true;
    load(paths, hints);
}

void OpenController::openStudy(const StudyChoice& choice)
{
    originalPath_.reset();
    opensAsView_ = false;
    furtherRuns_ = choice.runs.mid(1);
    io::OpenHints hints{choice.seriesId.toStdString(), {}, foldersInUse()};
    hints.scanUse = scanUse();
    load((choice.folder.isEmpty() ? QStringList() : QStringList{choice.folder}) +
             choice.runs.first(std::min<qsizetype>(choice.runs.size(), 1)),
         hints);
}

/// Returns the use of an opened scan, which may belong to vessels that come from a file if there is no scan yet.
io::ScanUse OpenController::scanUse() const
{
    const core::Case& current = document_.current();
    if (!current.vessels.tree) {
        return io::ScanUse::TraceOrShow;
    }
    const bool isOfFile = current.vessels.input.kind != core::VesselInputKind::Volume;
    return !current.vessels.scan && isOfFile ? io::ScanUse::Ask : io::ScanUse::Trace;
}

void OpenController::openScan(io::ScanUse use)
{
    io::OpenHints hints{pendingSeries_.toStdString(), {}, {}};
    hints.scanUse = use;
    load(pendingPaths_, hints);
}

void OpenController::openView(const QStringList& paths)
{
    opensAsView_ = true;
    furtherRuns_.clear();
    load(paths, {{}, {}, foldersInUse()});
}

/// Opens the next run of a study as a view; does nothing if the case has no vessels.
void OpenController::openNextRun()
{
    if (furtherRuns_.isEmpty()) {
        return;
    }
    if (!document_.current().vessels.tree || !document_.current().shown().angiogram) {
        furtherRuns_.clear();
        emit opened(
            {tr("Additional runs can be added as views only if the case has vessels. Open the vessels first, then the "
                "runs again.")});
        return;
    }
    opensAsView_ = true;
    load({furtherRuns_.takeFirst()}, {{}, {}, foldersInUse()});
}

void OpenController::openCopy(const QString& copy, const QString& original)
{
    io::OpenHints hints{{}, {}, foldersInUse()};
    if (!original.isEmpty()) {
        hints.searchFolders.insert(hints.searchFolders.begin(), QFileInfo(original).absolutePath().toStdString());
    }
    opensAsView_ = false;
    furtherRuns_.clear();
    originalPath_ = original;
    copyPath_ = copy;
    load({copy}, hints);
}

void OpenController::openInUnit(double unitMm)
{
    io::OpenHints hints{{}, {}, foldersInUse()};
    hints.scanUse = scanUse();
    hints.unitMm = unitMm;
    load(pendingPaths_, hints);
}

void OpenController::openSeries(const QString& seriesId)
{
    io::OpenHints hints{seriesId.toStdString(), {}, {}};
    hints.scanUse = scanUse();
    load(pendingPaths_, hints);
}

void OpenController::openWithInputs(const io::MovedInputs& moved, const QString& searchFolder)
{
    io::OpenHints hints{{}, movedInputs_, foldersInUse()};
    hints.moved.insert(moved.begin(), moved.end());
    if (!searchFolder.isEmpty()) {
        hints.searchFolders.insert(hints.searchFolders.begin(), searchFolder.toStdString());
    }
    load(pendingPaths_, hints);
}

void OpenController::openWithoutOptional()
{
    io::OpenHints hints{{}, movedInputs_, {}};
    hints.skipsOptionalInputs = true;
    load(pendingPaths_, hints);
}

void OpenController::addPendingView()
{
    if (auto opening = std::exchange(pendingOpening_, std::nullopt)) {
        opening->mode = Opening::Mode::AddView;
        confirmPatient(*opening);
    }
}

void OpenController::replaceImage()
{
    if (const auto opening = std::exchange(pendingOpening_, std::nullopt)) {
        confirmPatient(*opening);
    }
}

void OpenController::replaceOpenCase()
{
    if (const auto opening = std::exchange(pendingOpening_, std::nullopt)) {
        confirmPatient(*opening);
    }
}

void OpenController::openMismatched(bool isSamePatient)
{
    if (auto opening = std::exchange(pendingOpening_, std::nullopt)) {
        opening->isSamePatient = isSamePatient;
        apply(*opening);
    }
}

void OpenController::load(const QStringList& paths, const io::OpenHints& hints)
{
    if (paths.isEmpty()) {
        return;
    }
    if (document_.isInTrial()) {
        emit failed(tr("A blind trial is in progress. End it before opening another file."), paths);
        return;
    }
    if (document_.isLocked()) {
        emit failed(tr("A registration is running. Stop it before opening another file."), paths);
        return;
    }
    abandon();
    job_ = new LoadJob(this);
    connect(job_, &LoadJob::finished, this, [this, paths, series = hints.seriesId](const io::LoadedInputs& inputs) {
        finish();
        pendingSeries_ = QString::fromStdString(series);
        take(inputs, paths);
    });
    connect(job_, &LoadJob::failed, this, [this, paths](const core::Message& reason) {
        finish();
        emit failed(ui::messageText(reason), paths);
    });
    const QString what = tr("Reading %1…").arg(namesOf(paths));
    connect(job_, &LoadJob::progressed, this, [this, what](double fraction) { emit progressed(what, fraction); });
    emit started(what);
    job_->start(paths, hints);
}

void OpenController::abandon()
{
    if (job_) {
        finish();
    }
    pendingOpening_.reset();
    pendingPose_.reset();
}

void OpenController::finish()
{
    job_->disconnect(this);
    job_->deleteLater();
    job_ = nullptr;
    emit ended();
}

/// If reading stopped because a decision is needed, asks the user for the series, the use of the scan or the location
/// of missing inputs. Returns whether it has asked.
bool OpenController::requestDecision(const io::LoadedInputs& inputs, const QStringList& paths)
{
    if (inputs.isStudyChoiceNeeded) {
        emit studyOffered(paths.front());
        return true;
    }
    if (!inputs.offeredSeries.empty()) {
        pendingPaths_ = paths;
        emit seriesChoiceNeeded(paths.join(QStringLiteral(", ")), inputs.offeredSeries);
        return true;
    }
    if (inputs.extentInUnknownUnits) {
        pendingPaths_ = paths;
        emit unitNeeded(namesOf(paths), *inputs.extentInUnknownUnits);
        return true;
    }
    if (inputs.isScanUseUndecided) {
        pendingPaths_ = paths;
        emit scanChoiceNeeded(namesOf(paths));
        return true;
    }
    if (!inputs.missing.empty()) {
        pendingPaths_ = paths;
        movedInputs_ = inputs.moved;
        QStringList missing;
        for (const io::MissingInput& missingInput : inputs.missing) {
            missing << QString::fromStdString(missingInput.path);
        }
        emit inputsMissing(paths.front(), missing, std::ranges::all_of(inputs.missing, &io::MissingInput::isOptional));
        return true;
    }
    return false;
}

void OpenController::take(const io::LoadedInputs& inputs, const QStringList& paths)
{
    if (document_.isInTrial()) {
        emit failed(tr("A blind trial was started in the meantime. Open the file again after the trial has finished."),
                    paths);
        return;
    }
    if (document_.isLocked()) {
        emit failed(
            tr("A registration was started in the meantime. Open the file again after the registration has finished."),
            paths);
        return;
    }
    if (requestDecision(inputs, paths)) {
        return;
    }
    if (inputs.pose || !inputs.fiducials.empty()) {
        applyShared(inputs, paths);
        return;
    }
    const bool replaces = inputs.loadedCase || io::isCompleteCase(inputs);
    Opening opening{inputs, paths, replaces ? Opening::Mode::Replace : Opening::Mode::Join, originalPath_};
    if (std::exchange(opensAsView_, false)) {
        opening.mode = Opening::Mode::AddView;
    } else if (isAnotherView(document_.current(), inputs)) {
        pendingOpening_ = std::move(opening);
        emit viewChoiceNeeded(namesOf(paths));
        return;
    }
    if (opening.mode == Opening::Mode::Replace && document_.isModified()) {
        pendingOpening_ = std::move(opening);
        emit replacementNeedsConsent();
        return;
    }
    confirmPatient(opening);
}

/// Applies a pose or points to the open case; their file does not become an input of the case.
void OpenController::applyShared(const io::LoadedInputs& inputs, const QStringList& paths)
{
    opensAsView_ = false;
    if (!inputs.pose) {
        const auto notes = addTargetPoints(document_, inputs.fiducials, namesOf(paths));
        if (notes) {
            emit poseOpened(notes.value());
        } else {
            emit failed(ui::messageText(notes.error().message), paths);
        }
        return;
    }
    const PoseCompatibility fit = checkPoseCompatibility(document_.current(), *inputs.pose);
    if (!fit.refusal.isEmpty()) {
        emit failed(fit.refusal, paths);
        return;
    }
    if (!fit.isOtherCamera) {
        applyOpenedPose(*inputs.pose, IncomingCamera::OfCase, namesOf(paths));
        return;
    }
    pendingPose_ = inputs.pose;
    pendingPoseName_ = namesOf(paths);
    emit cameraChoiceNeeded(pendingPoseName_);
}

void OpenController::openPendingPose(IncomingCamera camera)
{
    if (const auto pose = std::exchange(pendingPose_, std::nullopt); pose && !document_.isLocked()) {
        applyOpenedPose(*pose, camera, pendingPoseName_);
    }
}

void OpenController::applyOpenedPose(const io::PoseWithCamera& pose, IncomingCamera camera, const QString& name)
{
    const QStringList notes = applyPose(document_, pose, camera, name);
    emit poseOpened(QStringList{tr("Pose from %1 applied.").arg(name)} + notes);
}

/// Adds the opened files to the case; asks first if they seem to belong to another patient.
void OpenController::confirmPatient(const Opening& opening)
{
    const auto wanted = mergeIntoCase(document_.current(), opening);
    const io::LoadedInputs& inputs = opening.inputs;
    const bool saysWhose = inputs.angiogram || inputs.volume || inputs.loadedCase;
    const core::Messages mismatch = wanted && saysWhose ? core::findMismatch(wanted.value()) : core::Messages();
    if (mismatch.empty()) {
        apply(opening);
        return;
    }
    pendingOpening_ = opening;
    emit mismatchNeedsConsent(namesOf(opening.paths), mismatch, wanted.value());
}

void OpenController::apply(const Opening& opening)
{
    const auto notes = addToCase(document_, opening);
    if (notes) {
        if (opening.inputs.tree) {
            emit inputsAdded(opening.inputs.warnings);
        }
        emit opened(notes.value());
        openNextRun();
    } else {
        furtherRuns_.clear();
        emit failed(ui::messageText(notes.error().message), opening.paths);
    }
}

}   // namespace angiopose::app
