#include "app/files/save_controller.h"

#include "app/files/recent_cases.h"
#include "app/preferences/save_folder.h"
#include "app/preferences/settings.h"
#include "io/case/case_file.h"
#include "io/case/overwrite_case.h"
#include "ui/dialogs/message_dialog.h"
#include "ui/dialogs/recovery_dialog.h"
#include "ui/words/language.h"
#include "ui/words/message_text.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QWidget>

#include <algorithm>
#include <utility>

namespace angiopose::app {
namespace {

QString suggestedCasePath(const CaseDocument& document)
{
    if (!document.path().isEmpty()) {
        return document.path();
    }
    const QString title = QString::fromStdString(document.current().title);
    const QString name = title.isEmpty() ? QStringLiteral("case") : title;
    return suggestedPath({}, name + QStringLiteral(".angiopose"));
}

}   // namespace

SaveController::SaveController(CaseDocument& document, ExportController& files, QWidget& window, QObject* parent)
    : QObject(parent),
      document_(document),
      exportController_(files),
      window_(window),
      autosave_(document),
      fileGuard_(document, files_)
{
    connect(&autosave_, &Autosave::saved, this, &SaveController::forgetRecovered);
    connect(&autosave_, &Autosave::failed, this, &SaveController::autosaveFailed);
    connect(&fileGuard_, &CaseFileGuard::foundOpenElsewhere, this, &SaveController::foundOpenElsewhere);
}

void SaveController::save(const std::function<void()>& whenSaved)
{
    if (document_.path().isEmpty()) {
        saveAs(whenSaved);
    } else {
        saveTo(document_.path(), whenSaved);
    }
}

SaveController::Savable SaveController::savable() const
{
    const core::Case& current = document_.current();
    return current.vessels.tree && current.shown().angiogram ? Savable::Case
           : current.vessels.tree                            ? Savable::Vessels
                                                             : Savable::Nothing;
}

bool SaveController::hasUnsavedWork() const
{
    const bool isKept = savable() == Savable::Vessels && savedVesselsState_ == document_.state();
    return document_.hasUnsavedWork() && !isKept && discardedState_ != document_.state();
}

void SaveController::saveVessels(const std::function<void()>& whenSaved)
{
    exportController_.askForVesselFile([this, state = document_.state(), whenSaved] {
        savedVesselsState_ = state;
        if (whenSaved) {
            whenSaved();
        }
    });
}

void SaveController::offerToSaveVessels(const std::function<void()>& whenSaved)
{
    auto* question = new ui::QuestionDialog(
        {tr("No angiogram yet"),
         tr("A case requires vessels and an angiogram. Without an angiogram, only the vessels can be saved, as "
            "centerlines. To create a case later, open these vessels together with an angiogram."),
         {}},
        {tr("Save vessels…"), tr("Cancel")}, &window_);
    question->setObjectName(QStringLiteral("vesselsQuestion"));
    connect(
        question, &ui::QuestionDialog::answered, this,
        [this, whenSaved](int index) {
            if (index == 0) {
                saveVessels(whenSaved);
            }
        },
        Qt::QueuedConnection);   // queued: this dialog closes before another one opens
    question->open();
}

/// Rejects a case that cannot be saved before asking for a file name.
bool SaveController::reportSaveProblem(const std::function<void()>& whenSaved)
{
    if (savable() == Savable::Vessels) {
        offerToSaveVessels(whenSaved);
        return true;
    }
    QString why = ui::messageText(io::findSaveObstacle(document_.current()));
    if (!why.isEmpty()) {
        why[0] = why[0].toUpper();
        emit failed(why);
    }
    return !why.isEmpty();
}

void SaveController::saveAs(const std::function<void()>& whenSaved)
{
    if (reportSaveProblem(whenSaved)) {
        return;
    }
    auto* dialog = new QFileDialog(&window_, tr("Save case"), suggestedCasePath(document_), tr("Cases (*.angiopose)"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setDefaultSuffix(QStringLiteral("angiopose"));
    connect(dialog, &QFileDialog::fileSelected, this,
            [this, whenSaved](const QString& path) { saveTo(path, whenSaved); });
    dialog->open();
}

void SaveController::saveTo(const QString& path, const std::function<void()>& whenSaved,
                            CaseFileGuard::Overwrite replaced)
{
    if (document_.isInTrial()) {
        emit failed(tr("A blind trial is in progress. End it before saving."));
        return;
    }
    emit started();
    files_.run(
        [save = fileGuard_.guardedSave(document_.current(), path, replaced), snapshot = document_.current(), path,
         withPicture = settings::recentThumbnails.read()]() -> core::Result<QString> {
            if (const auto written = save(); !written) {
                return written.error();
            }
            if (withPicture) {
                storeCaseThumbnail(snapshot, path);
            }
            return path;
        },
        [this, path, state = document_.state(), whenSaved](const core::Result<QString>& written) {
            if (!written && io::isConcurrentChange(written.error())) {
                confirmOverwrite(path, whenSaved);
                return;
            }
            if (!written) {
                emit failed(ui::messageText(written.error().message));
                return;
            }
            finishSave(path, state);
            pruneCaseThumbnails(settings::recentThumbnails.read() ? recentCases()
                                                                  : QStringList());   // as in the current setting
            if (whenSaved) {
                whenSaved();
            }
        });
}

/// Asks before overwriting changes that another window or program has saved.
void SaveController::confirmOverwrite(const QString& path, const std::function<void()>& whenSaved)
{
    auto* question =
        new ui::QuestionDialog({tr("Changed elsewhere"),
                                tr("“%1” was saved by another window or program after it was opened here. Overwriting "
                                   "discards the changes saved there; reloading discards the changes made here.")
                                    .arg(QFileInfo(path).fileName()),
                                {}},
                               {tr("Save as…"), tr("Overwrite"), tr("Reload"), tr("Cancel")}, &window_);
    question->setObjectName(QStringLiteral("changedElsewhere"));
    connect(
        question, &ui::QuestionDialog::answered, this,
        [this, path, whenSaved](int index) {
            if (index == 0) {
                saveAs(whenSaved);
            } else if (index == 1) {
                saveTo(path, whenSaved, CaseFileGuard::Overwrite::AnyContent);
            } else if (index == 2) {
                discardedState_ = document_.state();
                emit reloadRequested(path);
            }
        },
        Qt::QueuedConnection);   // queued: this dialog closes before another one opens
    question->open();
}

void SaveController::finishSave(const QString& path, const CaseState& written)
{
    document_.markSaved(path, written);
    forgetRecovered();
    settings::lastFolder.write(QFileInfo(path).absolutePath());
    rememberCase(path);
    if (!document_.isModified()) {
        autosave_.discard();
    }
    emit saved();
}

void SaveController::offerRecovery()
{
    const std::vector<RecoveryCopy> copies = Autosave::recoveryCopies();
    if (copies.empty()) {
        return;
    }
    std::vector<ui::RecoveryRow> rows;
    for (const RecoveryCopy& copy : copies) {
        const QFileInfo original(copy.original);
        const QString title = copy.title.isEmpty() ? tr("Untitled case") : tr("%1 (not saved)").arg(copy.title);
        const QString untitled = copy.isVesselsOnly() ? tr("Vessels without an angiogram") : title;
        rows.push_back({copy.path, copy.original.isEmpty() ? untitled : original.fileName(),
                        ui::languageLocale().toString(copy.savedAt, QLocale::ShortFormat),
                        copy.original.isEmpty() ? QString() : original.absolutePath()});
    }
    auto* dialog = new ui::RecoveryDialog(rows, &window_);
    const auto copyAt = [copies](const QString& path) { return *std::ranges::find(copies, path, &RecoveryCopy::path); };
    connect(dialog, &ui::RecoveryDialog::recoverRequested, this,
            [this, copyAt](const QString& path) { recover(copyAt(path)); });
    connect(dialog, &ui::RecoveryDialog::discardRequested, this, [copyAt](const QStringList& paths) {
        for (const QString& path : paths) {
            Autosave::forget(copyAt(path));
        }
    });
    dialog->open();
}

void SaveController::recover(const RecoveryCopy& copy)
{
    if (copy.isVesselsOnly()) {
        recoveredVessels_ = Autosave::adoptVessels(copy);
        emit vesselsRecovered(recoveredVessels_);
        return;
    }
    requestedCopy_ = copy;
    emit recoveryRequested(copy);
}

void SaveController::noteOpened(const QString& copy)
{
    const auto wanted = std::exchange(requestedCopy_, std::nullopt);
    recoveredCopy_ = wanted && wanted->path == copy ? wanted : std::nullopt;
    if (recoveredCopy_) {
        fileGuard_.expectUnchangedSince(recoveredCopy_->savedAt);
        autosave_.saveSoon();
    }
    const QString vessels = std::exchange(recoveredVessels_, {});
    if (!vessels.isEmpty() && document_.current().vessels.file.path == vessels.toStdString()) {
        document_.markUnsaved();   // the user has not chosen a name for the file yet
    }
}

void SaveController::forgetRecovered()
{
    if (recoveredCopy_) {
        Autosave::forget(*std::exchange(recoveredCopy_, std::nullopt));
    }
}

QString SaveController::saveState() const
{
    if (document_.isEmpty()) {
        return {};
    }
    if (!document_.isModified()) {
        return tr("All changes saved");
    }
    if (savable() == Savable::Vessels && savedVesselsState_ == document_.state()) {
        return tr("Vessels saved as centerlines");
    }
    if (autosave_.isFailing()) {
        return tr("Not autosaved");
    }
    if (const auto savedAt = autosave_.lastSaved()) {
        const qint64 seconds = savedAt->secsTo(QDateTime::currentDateTime());
        return seconds < 90 ? tr("Autosaved %1 s ago").arg(seconds) : tr("Autosaved %1 min ago").arg(seconds / 60);
    }
    return document_.hasUnsavedWork() ? tr("Unsaved changes") : tr("Not saved yet");
}

}   // namespace angiopose::app
