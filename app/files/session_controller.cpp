#include "app/files/session_controller.h"

#include "app/archive/archive_controller.h"
#include "app/archive/archive_sender.h"
#include "app/preferences/settings.h"
#include "ui/actions/window_actions.h"
#include "ui/dialogs/message_dialog.h"
#include "ui/panels/bottom_strip.h"
#include "ui/panels/welcome_page.h"
#include "ui/words/language.h"
#include "ui/words/message_text.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QProcess>

#include <utility>

namespace angiopose::app {

SessionController::SessionController(CaseDocument& document, TargetProvider& target,
                                     RegistrationController& registration, const PosePreview& preview,
                                     Notifications& notifications, const Ui& ui, QObject* parent)
    : QObject(parent),
      document_(document),
      notifications_(notifications),
      ui_(ui),
      openController_(document),
      exportController_(document, target, preview, ui.view, ui.dialogParent),
      reportController_(document, target, exportController_, ui.dialogParent),
      dicomController_(document, target, exportController_, ui.dialogParent),
      packController_(document, ui.strip, ui.dialogParent),
      deidentifyController_(ui.strip, ui.dialogParent),
      saveController_(document, exportController_, ui.dialogParent),
      dialogs_(document, openController_, saveController_, notifications,
               {ui.actions, ui.welcome, ui.strip, ui.dialogParent}),
      studyController_(openController_, notifications,
                       {*ui.actions[ui::Command::HideIdentity], ui.strip, ui.dialogParent}),
      closeController_(document, saveController_, registration, ui.actions, ui.dialogParent),
      recentController_(document, {ui.actions, ui.welcome}),
      archiveController_(std::make_unique<ArchiveController>(
          ArchiveController::Ui{*ui.actions[ui::Command::HideIdentity], ui.dialogParent})),
      archiveSender_(std::make_unique<ArchiveSender>(archiveController_->list(), ui.dialogParent)),
      privacyController_(*ui.actions[ui::Command::PrivateMode], ui.dialogParent),
      auditController_(document, *ui.actions[ui::Command::WriteAuditLog], ui.dialogParent)
{
    connectFiles();
    connectOpening();
    connectSaving();
    connectExporting();
    connectDicom();
    connectPacking();
    connectArchives();
    connectDeidentifying();
    connectAudit(registration);
    connect(&closeController_, &CloseController::aboutToClose, this, &SessionController::aboutToClose);
    connect(&closeController_, &CloseController::windowMayClose, this, &SessionController::windowMayClose);
}

SessionController::~SessionController() = default;

void SessionController::begin(const QStringList& paths)
{
    QStringList absolute;
    for (const QString& path : paths) {
        absolute << QFileInfo(path).absoluteFilePath();
    }
    if (settings::noticeAccepted.read()) {
        start(absolute);
    } else {
        showNotice(absolute);
    }
}

void SessionController::start(const QStringList& paths)
{
    if (paths.isEmpty()) {
        saveController_.offerRecovery();
    } else {
        isRecoveryPending_ = true;   // recovery is offered after the questions on opening have been answered
        open(paths);
    }
}

void SessionController::offerRecoveryIfPending()
{
    if (std::exchange(isRecoveryPending_, false)) {
        saveController_.offerRecovery();
    }
}

void SessionController::abandonLoading()
{
    openController_.abandon();
    studyController_.abandon();
}

/// Shows the notice and opens the files afterward, since their questions would cover the notice.
void SessionController::showNotice(const QStringList& paths)
{
    auto* notice = new ui::QuestionDialog(
        {tr("Not for clinical use"),
         tr("AngioPose is research software, not a medical device: do not use it for diagnosis, treatment or "
            "navigation. Results can be wrong; a single projection cannot fully determine depth."),
         {}},
        {tr("I understand")}, &ui_.dialogParent);
    notice->setObjectName(QStringLiteral("noticeDialog"));
    connect(notice, &ui::QuestionDialog::answered, this, [this, paths] {
        settings::noticeAccepted.write(true);
        start(paths);
        if (paths.isEmpty()) {
            emit firstStarted();
        }
    });
    notice->open();
}

void SessionController::connectFiles()
{
    connect(&recentController_, &RecentController::openRequested, this, [this](const QString& path) { open({path}); });
    connect(ui_.actions[ui::Command::Close], &QAction::triggered, &ui_.dialogParent, &QWidget::close);
    connect(ui_.actions[ui::Command::NewWindow], &QAction::triggered, this, &SessionController::openNewWindow);
}

void SessionController::connectOpening()
{
    connect(&openController_, &OpenController::started, this,
            [this](const QString& what) { ui_.strip.showBusy(what); });
    connect(&openController_, &OpenController::progressed, this, [this](const QString& what, double fraction) {
        if (fraction > 0.0) {
            ui_.strip.showProgress(what, fraction);
        }
    });
    connect(&openController_, &OpenController::ended, this, [this] { ui_.strip.showIdle(tr("Ready")); });
    connect(&openController_, &OpenController::opened, this, [this](const QStringList& notes) {
        saveController_.noteOpened(openController_.openedCopy());
        recentController_.rebuild();
        recentController_.makeThumbnail();
        openingNotes_ = notes;
        if (notes.isEmpty()) {
            notifications_.showNote(tr("Opened"));
        } else {
            notifications_.showWarnings(ui::joinSentences(notes));
        }
        offerRecoveryIfPending();
    });
    connect(&openController_, &OpenController::poseOpened, this, [this](const QStringList& notes) {
        if (notes.size() == 1) {
            notifications_.showNote(notes.front());
        } else {
            notifications_.showWarnings(ui::joinSentences(notes));
        }
    });
    connect(&openController_, &OpenController::failed, this, [this](const QString& reason, const QStringList& paths) {
        notifications_.showProblem(paths.size() == 1 ? tr("Could not open the file") : tr("Could not open the files"),
                                   reason, paths);
        saveController_.retainWork();
        offerRecoveryIfPending();
    });
}

void SessionController::connectSaving()
{
    ui::WindowActions& actions = ui_.actions;
    connect(actions[ui::Command::Save], &QAction::triggered, this, [this] { saveController_.save(); });
    connect(actions[ui::Command::SaveAs], &QAction::triggered, this, [this] { saveController_.saveAs(); });
    connect(&saveController_, &SaveController::failed, this, [this](const QString& reason) {
        notifications_.showProblem(tr("Could not save"), reason, {document_.path()});
    });
    connect(&saveController_, &SaveController::started, this, [this] { notifications_.showNote(tr("Saving…")); });
    connect(&saveController_, &SaveController::saved, this, [this] {
        recentController_.rebuild();
        notifications_.showNote(tr("Saved"));
    });
    connect(&saveController_, &SaveController::autosaveFailed, this, [this](const QString& reason) {
        notifications_.showWarnings(tr("Autosave failed; AngioPose retries every minute. %1").arg(reason));
    });
    connect(&saveController_, &SaveController::foundOpenElsewhere, this, [this](const QString& words) {
        notifications_.showWarnings(ui::joinSentences(QStringList{words} + openingNotes_));
    });
    connect(&saveController_, &SaveController::reloadRequested, this, [this](const QString& path) { open({path}); });
    connect(&saveController_, &SaveController::recoveryRequested, this,
            [this](const RecoveryCopy& copy) { openController_.openCopy(copy.path, copy.original); });
    connect(&saveController_, &SaveController::vesselsRecovered, this,
            [this](const QString& path) { openController_.open({path}); });
}

void SessionController::connectExporting()
{
    ui::WindowActions& actions = ui_.actions;
    connect(actions[ui::Command::ExportOverlay], &QAction::triggered, &exportController_,
            &ExportController::openOverlayDialog);
    connect(actions[ui::Command::ExportReport], &QAction::triggered, &reportController_, &ReportController::openDialog);
    connect(actions[ui::Command::ExportResult], &QAction::triggered, &exportController_,
            &ExportController::askForResultFile);
    connect(actions[ui::Command::ExportPose], &QAction::triggered, &exportController_,
            &ExportController::askForPoseFile);
    connect(actions[ui::Command::ExportTrace], &QAction::triggered, &exportController_,
            &ExportController::askForTraceFile);
    connect(actions[ui::Command::ExportMeasurements], &QAction::triggered, &exportController_,
            &ExportController::askForMeasurementFile);
    connect(actions[ui::Command::ExportTargetPoints], &QAction::triggered, &exportController_,
            &ExportController::askForTargetPointFile);
    connect(actions[ui::Command::ExportDeformed], &QAction::triggered, &exportController_,
            &ExportController::askForDeformedFile);
    connect(actions[ui::Command::ExportMask], &QAction::triggered, &exportController_,
            &ExportController::askForMaskFile);
    connect(actions[ui::Command::ExportVessels], &QAction::triggered, this, [this] { saveController_.saveVessels(); });
    connect(&exportController_, &ExportController::started, this, [this] { notifications_.showNote(tr("Writing…")); });
    connect(&exportController_, &ExportController::exported, this, &SessionController::exported);
    connect(&exportController_, &ExportController::written, this,
            [this](const QString& path) { notifications_.showNote(tr("Saved: %1").arg(QFileInfo(path).fileName())); });
    const auto showFailure = [this](const QString& reason) {
        notifications_.showProblem(tr("Could not export"), reason);
    };
    connect(&exportController_, &ExportController::failed, this, showFailure);
    connect(&reportController_, &ReportController::failed, this, showFailure);
}

void SessionController::connectDicom()
{
    connect(ui_.actions[ui::Command::ExportDicom], &QAction::triggered, &dicomController_,
            &DicomController::openDialog);
    connect(&dicomController_, &DicomController::started, this, [this] { notifications_.showNote(tr("Writing…")); });
    connect(&dicomController_, &DicomController::written, this,
            [this](const QString& folder, const QStringList& notes) {
                reportWritten(tr("DICOM objects written: %1").arg(QFileInfo(folder).fileName()), notes);
            });
    connect(&dicomController_, &DicomController::failed, this,
            [this](const QString& reason) { notifications_.showProblem(tr("Could not export"), reason); });
}

/// Reports the file that was written, with remarks.
void SessionController::reportWritten(const QString& there, const QStringList& notes)
{
    if (notes.isEmpty()) {
        notifications_.showNote(there);
    } else {
        notifications_.showWarnings(ui::joinSentences(QStringList{there} + notes));
    }
    emit exported();
}

void SessionController::connectPacking()
{
    connect(ui_.actions[ui::Command::ShareCase], &QAction::triggered, &packController_, &PackController::openDialog);
    connect(&packController_, &PackController::stopped, this,
            [this] { notifications_.showNote(tr("Stopped; nothing was written.")); });
    connect(&packController_, &PackController::written, this, [this](const QString& path, const QStringList& notes) {
        reportWritten(tr("Case bundle saved: %1").arg(QFileInfo(path).fileName()), notes);
    });
    connect(&packController_, &PackController::failed, this, [this](const QString& reason) {
        notifications_.showProblem(tr("Could not save the case bundle"), reason);
    });
}

void SessionController::connectArchives()
{
    connect(ui_.actions[ui::Command::QueryPacs], &QAction::triggered, archiveController_.get(),
            &ArchiveController::show);
    connect(archiveController_.get(), &ArchiveController::retrieved, &studyController_, &StudyController::openFolders);
    connect(archiveController_.get(), &ArchiveController::reported, &notifications_, &Notifications::showNote);
    connect(ui_.actions[ui::Command::SendToArchive], &QAction::triggered, &dicomController_,
            &DicomController::selectObjectsToSend);
    connect(&dicomController_, &DicomController::wanted, this, [this](const ui::DicomExportOptions& choice) {
        archiveSender_->openDialog(dicomController_.makeWriter(choice));
    });
    connect(archiveSender_.get(), &ArchiveSender::sent, this, &SessionController::reportWritten);
}

void SessionController::connectDeidentifying()
{
    connect(ui_.actions[ui::Command::DeidentifyFiles], &QAction::triggered, &deidentifyController_,
            &DeidentifyController::openDialog);
    connect(&deidentifyController_, &DeidentifyController::written, this,
            [this](const QString&, const QString& words) { notifications_.showWarnings(words); });
    connect(&deidentifyController_, &DeidentifyController::partlyRejected, this,
            [this](const QString& words, const QString& lines) {
                ui::MessageDialog::show({tr("Some files were skipped"), words, lines}, &ui_.dialogParent);
            });
    connect(&deidentifyController_, &DeidentifyController::stopped, this,
            [this] { notifications_.showNote(tr("Stopped; nothing was written.")); });
    connect(&deidentifyController_, &DeidentifyController::failed, this, [this](const QString& reason) {
        notifications_.showProblem(tr("Could not de-identify the files"), reason);
    });
}

void SessionController::connectAudit(RegistrationController& registration)
{
    using io::AuditEvent;
    connect(&openController_, &OpenController::opened, &auditController_, &AuditController::noteOpened);
    connect(&saveController_, &SaveController::saved, &auditController_,
            [this] { auditController_.noteCase(AuditEvent::Saved); });
    connect(&registration, &RegistrationController::finished, &auditController_,
            [this] { auditController_.noteCase(AuditEvent::Registered); });
    connect(&exportController_, &ExportController::written, &auditController_,
            [this](const QString& path) { auditController_.note(AuditEvent::Exported, {path}); });
    connect(&dicomController_, &DicomController::written, &auditController_,
            [this](const QString& folder) { auditController_.note(AuditEvent::Exported, {folder}); });
    connect(&packController_, &PackController::written, &auditController_,
            [this](const QString& path) { auditController_.note(AuditEvent::Packed, {path}); });
    connect(&deidentifyController_, &DeidentifyController::written, &auditController_,
            [this](const QString& folder) { auditController_.note(AuditEvent::Deidentified, {folder}); });
    connect(archiveSender_.get(), &ArchiveSender::sent, &auditController_,
            [this] { auditController_.noteCase(AuditEvent::Sent); });
    const auto showIncomplete = [this](const QString& reason) {
        notifications_.showProblem(tr("The audit log is incomplete"), reason);
    };
    connect(&auditController_, &AuditController::failed, this, showIncomplete);
    connect(archiveController_.get(), &ArchiveController::auditFailed, this, showIncomplete);
}

/// Starts a separate process, so that a problem with one case cannot affect another.
void SessionController::openNewWindow()
{
    if (!QProcess::startDetached(QCoreApplication::applicationFilePath(), {})) {
        notifications_.showProblem(
            tr("Could not open another window"),
            tr("Could not start another AngioPose process. Start AngioPose from the system menu."));
    }
}

}   // namespace angiopose::app
