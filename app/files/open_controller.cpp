#include "app/files/open_controller.h"

#include "app/document/assemble_case.h"
#include "app/document/edit_case.h"
#include "app/files/open_notes.h"
#include "app/files/recent_cases.h"
#include "app/files/view_from_inputs.h"
#include "app/preferences/settings.h"
#include "core/case/case_views.h"
#include "ui/words/message_text.h"

#include <QFileInfo>

#include <algorithm>
#include <utility>

namespace angiopose::app {
namespace {

/// Where the user has been lately.
QStringList foldersInUse()
{
    QStringList folders;
    for (const QString& path : recentCases()) {
        folders << QFileInfo(path).absolutePath();
    }
    if (const QString last = settings::lastFolder.read(); !last.isEmpty()) {
        folders << last;
    }
    folders.removeDuplicates();
    return folders;
}

}   // namespace

OpenController::OpenController(CaseDocument& document, QObject* parent) : QObject(parent), document_(document) {}

void OpenController::open(const QStringList& paths)
{
    original_.reset();
    asView_ = false;
    OpenHints hints{{}, {}, foldersInUse()};
    hints.scanUse = scanUse();
    load(paths, hints);
}

/// Vessels of a file without a scan: a scan that is opened may be theirs.
ScanUse OpenController::scanUse() const
{
    const core::Case& current = document_.current();
    if (!current.vessels.tree) {
        return ScanUse::TraceOrShow;
    }
    const bool isOfFile = current.vessels.input.kind != core::VesselInputKind::Volume;
    return !current.vessels.scan && isOfFile ? ScanUse::Ask : ScanUse::Trace;
}

void OpenController::openScan(ScanUse use)
{
    OpenHints hints{askedSeries_, {}, {}};
    hints.scanUse = use;
    load(askedPaths_, hints);
}

void OpenController::openView(const QStringList& paths)
{
    asView_ = true;
    load(paths, {{}, {}, foldersInUse()});
}

void OpenController::openCopy(const QString& copy, const QString& original)
{
    OpenHints hints{{}, {}, foldersInUse()};
    if (!original.isEmpty()) {
        hints.searchFolders.prepend(QFileInfo(original).absolutePath());
    }
    asView_ = false;
    original_ = original;
    copy_ = copy;
    load({copy}, hints);
}

void OpenController::openInUnit(double unitMm)
{
    OpenHints hints{{}, {}, foldersInUse()};
    hints.scanUse = scanUse();
    hints.unitMm = unitMm;
    load(askedPaths_, hints);
}

void OpenController::openSeries(const QString& seriesId)
{
    OpenHints hints{seriesId, {}, {}};
    hints.scanUse = scanUse();
    load(askedPaths_, hints);
}

void OpenController::openWithInputs(const io::MovedInputs& moved, const QString& searchFolder)
{
    OpenHints hints{{}, moved_, foldersInUse()};
    hints.moved.insert(moved.begin(), moved.end());
    if (!searchFolder.isEmpty()) {
        hints.searchFolders.prepend(searchFolder);
    }
    load(askedPaths_, hints);
}

void OpenController::openWithoutOptional()
{
    OpenHints hints{{}, moved_, {}};
    hints.withoutOptional = true;
    load(askedPaths_, hints);
}

void OpenController::addWaitingView()
{
    if (const auto inputs = std::exchange(waiting_, std::nullopt)) {
        addView(*inputs, askedPaths_);
    }
}

void OpenController::replaceImage()
{
    if (const auto inputs = std::exchange(waiting_, std::nullopt)) {
        join(*inputs, askedPaths_);
    }
}

void OpenController::load(const QStringList& paths, const OpenHints& hints)
{
    if (paths.isEmpty()) {
        return;
    }
    if (document_.isInTrial()) {
        emit failed(tr("A blind trial is under way. End it before opening another file."), paths);
        return;
    }
    if (document_.isLocked()) {
        emit failed(tr("A registration is running. Stop it before opening another file."), paths);
        return;
    }
    abandon();
    job_ = new LoadJob(this);
    connect(job_, &LoadJob::finished, this, [this, paths, series = hints.seriesId](const LoadedInputs& inputs) {
        finish();
        askedSeries_ = series;
        take(inputs, paths);
    });
    connect(job_, &LoadJob::failed, this, [this, paths](const core::Message& reason) {
        finish();
        emit failed(ui::messageText(reason), paths);
    });
    const QString what = tr("Reading %1 …").arg(namesOf(paths));
    connect(job_, &LoadJob::advanced, this, [this, what](double fraction) { emit advanced(what, fraction); });
    emit started(what);
    job_->start(paths, hints);
}

void OpenController::abandon()
{
    if (job_) {
        finish();
    }
    waiting_.reset();
}

void OpenController::finish()
{
    job_->disconnect(this);
    job_->deleteLater();
    job_ = nullptr;
    emit ended();
}

/// Nothing was read yet: which series, what the scan is for, or where the inputs of a case lie has to be known first.
bool OpenController::asksFirst(const LoadedInputs& inputs, const QStringList& paths)
{
    if (!inputs.offered.empty()) {
        askedPaths_ = paths;
        emit seriesChoiceNeeded(paths.join(QStringLiteral(", ")), inputs.offered);
        return true;
    }
    if (inputs.askedUnitsAcross) {
        askedPaths_ = paths;
        emit unitNeeded(namesOf(paths), *inputs.askedUnitsAcross);
        return true;
    }
    if (inputs.isScanAsked) {
        askedPaths_ = paths;
        emit scanChoiceNeeded(namesOf(paths));
        return true;
    }
    if (!inputs.missing.empty()) {
        askedPaths_ = paths;
        moved_ = inputs.moved;
        QStringList missing;
        for (const io::MissingInput& each : inputs.missing) {
            missing << QString::fromStdString(each.path);
        }
        emit inputsMissing(paths.front(), missing, std::ranges::all_of(inputs.missing, &io::MissingInput::isOptional));
        return true;
    }
    return false;
}

void OpenController::take(const LoadedInputs& inputs, const QStringList& paths)
{
    if (document_.isInTrial()) {
        emit failed(tr("A blind trial was started meanwhile. Open the file again when it has ended."), paths);
        return;
    }
    if (document_.isLocked()) {
        emit failed(tr("A registration was started meanwhile. Open the file again when it has ended."), paths);
        return;
    }
    if (asksFirst(inputs, paths)) {
        return;
    }
    if (std::exchange(asView_, false)) {
        addView(inputs, paths);
        return;
    }
    const bool replaces = inputs.wholeCase || makesNewCase(inputs);
    if (isAnotherView(inputs)) {
        waiting_ = inputs;
        askedPaths_ = paths;
        emit viewChoiceNeeded(namesOf(paths));
        return;
    }
    if (!replaces) {
        join(inputs, paths);
        return;
    }
    const QString path = inputs.wholeCase ? original_.value_or(paths.front()) : QString();
    if (document_.isModified()) {
        waiting_ = inputs;
        waitingPath_ = path;
        emit replacementNeedsConsent();
        return;
    }
    replaceWith(inputs, path);
}

void OpenController::replaceOpenCase()
{
    if (const auto inputs = std::exchange(waiting_, std::nullopt)) {
        replaceWith(*inputs, waitingPath_);
    }
}

void OpenController::replaceWith(const LoadedInputs& inputs, const QString& path)
{
    document_.replace(inputs.wholeCase ? *inputs.wholeCase : withInputs({}, inputs), path);
    if (!path.isEmpty()) {
        rememberCase(path);
    }
    if (original_ || !inputs.moved.empty()) {
        document_.markUnsaved();   // the file knows less than the window
    }
    emit opened(notesOf(inputs, document_.current()));
}

bool OpenController::isAnotherView(const LoadedInputs& inputs) const
{
    const core::Case& current = document_.current();
    const bool isNew = inputs.imageFile.path != current.shown().imageFile.path;
    return inputs.angiogram && !inputs.tree && !inputs.wholeCase && current.vessels.tree && current.shown().angiogram &&
           isNew;
}

void OpenController::addView(const LoadedInputs& inputs, const QStringList& paths)
{
    auto added = viewFrom(document_.current(), inputs, paths.front().toStdString());
    if (!added) {
        emit failed(ui::messageText(added.error().message), paths);
        return;
    }
    core::Case wanted = document_.current();
    wanted.views.push_back(std::move(added).value());
    const QStringList notes = notesOf(inputs, core::showingView(wanted, wanted.views.size() - 1));
    document_.push(std::make_unique<ChangeViews>(document_, ChangeViews::valuesOf(wanted),
                                                 [names = namesOf(paths)] { return tr("Add view %1").arg(names); }));
    emit opened(notes + QStringList{tr("View added: a click in the strip above the image shows it.")});
}

void OpenController::join(const LoadedInputs& inputs, const QStringList& paths)
{
    if (document_.isEmpty()) {
        document_.replace(withInputs(document_.current(), inputs), {});
    } else {
        document_.push(joinInputs(document_, withInputs(document_.current(), inputs),
                                  [names = namesOf(paths)] { return tr("Open %1").arg(names); }));
    }
    emit opened(notesOf(inputs, document_.current()) + notesOnScan(inputs, document_.current()));
}

}   // namespace angiopose::app