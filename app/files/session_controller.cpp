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
      open_(document),
      export_(document, target, preview, ui.view, ui.dialogParent),
      report_(document, target, export_, ui.dialogParent),
      dicom_(document, target, export_, ui.dialogParent),
      pack_(document, ui.strip, ui.dialogParent),
      deidentify_(ui.strip, ui.dialogParent),
      save_(document, export_, ui.dialogParent),
      dialogs_(document, open_, save_, notifications, {ui.actions, ui.welcome, ui.strip, ui.dialogParent}),
      studies_(open_, notifications, {*ui.actions[ui::Command::HideIdentity], ui.strip, ui.dialogParent}),
      close_(document, save_, registration, ui.actions, ui.dialogParent),
      recent_(document, {ui.actions, ui.welcome}),
      archive_(std::make_unique<ArchiveController>(
          ArchiveController::Ui{*ui.actions[ui::Command::HideIdentity], ui.dialogParent})),
      sender_(std::make_unique<ArchiveSender>(archive_->list(), ui.dialogParent)),
      privacy_(*ui.actions[ui::Command::PrivateMode], ui.dialogParent),
      audit_(document, *ui.actions[ui::Command::WriteAuditLog], ui.dialogParent)
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
    connect(&close_, &CloseController::aboutToClose, this, &SessionController::aboutToClose);
    connect(&close_, &CloseController::windowMayClose, this, &SessionController::windowMayClose);
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
        save_.offerRecovery();
    } else {
        isRecoveryPending_ = true;   // recovery is offered after the questions on opening have been answered
        open(paths);
    }
}

void SessionController::offerRecoveryIfPending()
{
    if (std::exchange(isRecoveryPending_, false)) {
        save_.offerRecovery();
    }
}

void SessionController::abandonLoading()
{
    open_.abandon();
    studies_.abandon();
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
    connect(&recent_, &RecentController::openRequested, this, [this](const QString& path) { open({path}); });
    connect(ui_.actions[ui::Command::Close], &QAction::triggered, &ui_.dialogParent, &QWidget::close);
    connect(ui_.actions[ui::Command::NewWindow], &QAction::triggered, this, &SessionController::openNewWindow);
}

void SessionController::connectOpening()
{
    connect(&open_, &OpenController::started, this, [this](const QString& what) { ui_.strip.showBusy(what); });
    connect(&open_, &OpenController::advanced, this, [this](const QString& what, double fraction) {
        if (fraction > 0.0) {
            ui_.strip.showProgress(what, fraction);
        }
    });
    connect(&open_, &OpenController::ended, this, [this] { ui_.strip.showIdle(tr("Ready")); });
    connect(&open_, &OpenController::opened, this, [this](const QStringList& notes) {
        save_.noteOpened(open_.openedCopy());
        recent_.rebuild();
        recent_.makeThumbnail();
        openingNotes_ = notes;
        if (notes.isEmpty()) {
            notifications_.showNote(tr("Opened"));
        } else {
            notifications_.showWarnings(ui::joinedSentences(notes));
        }
        offerRecoveryIfPending();
    });
    connect(&open_, &OpenController::poseOpened, this, [this](const QStringList& notes) {
        if (notes.size() == 1) {
            notifications_.showNote(notes.front());
        } else {
            notifications_.showWarnings(ui::joinedSentences(notes));
        }
    });
    connect(&open_, &OpenController::failed, this, [this](const QString& reason, const QStringList& paths) {
        notifications_.showProblem(paths.size() == 1 ? tr("Could not open the file") : tr("Could not open the files"),
                                   reason, paths);
        save_.retainWork();
        offerRecoveryIfPending();
    });
}

void SessionController::connectSaving()
{
    ui::WindowActions& actions = ui_.actions;
    connect(actions[ui::Command::Save], &QAction::triggered, this, [this] { save_.save(); });
    connect(actions[ui::Command::SaveAs], &QAction::triggered, this, [this] { save_.saveAs(); });
    connect(&save_, &SaveController::failed, this, [this](const QString& reason) {
        notifications_.showProblem(tr("Could not save"), reason, {document_.path()});
    });
    connect(&save_, &SaveController::started, this, [this] { notifications_.showNote(tr("Saving…")); });
    connect(&save_, &SaveController::saved, this, [this] {
        recent_.rebuild();
        notifications_.showNote(tr("Saved"));
    });
    connect(&save_, &SaveController::autosaveFailed, this, [this](const QString& reason) {
        notifications_.showWarnings(tr("Autosave failed; AngioPose retries every minute. %1").arg(reason));
    });
    connect(&save_, &SaveController::openElsewhere, this, [this](const QString& words) {
        notifications_.showWarnings(ui::joinedSentences(QStringList{words} + openingNotes_));
    });
    connect(&save_, &SaveController::reloadRequested, this, [this](const QString& path) { open({path}); });
    connect(&save_, &SaveController::recoveryRequested, this,
            [this](const RecoveryCopy& copy) { open_.openCopy(copy.path, copy.original); });
    connect(&save_, &SaveController::vesselsRecovered, this, [this](const QString& path) { open_.open({path}); });
}

void SessionController::connectExporting()
{
    ui::WindowActions& actions = ui_.actions;
    connect(actions[ui::Command::ExportOverlay], &QAction::triggered, &export_, &ExportController::askOverlay);
    connect(actions[ui::Command::ExportReport], &QAction::triggered, &report_, &ReportController::openDialog);
    connect(actions[ui::Command::ExportResult], &QAction::triggered, &export_, &ExportController::askResult);
    connect(actions[ui::Command::ExportPose], &QAction::triggered, &export_, &ExportController::askPose);
    connect(actions[ui::Command::ExportTrace], &QAction::triggered, &export_, &ExportController::askTrace);
    connect(actions[ui::Command::ExportMeasurements], &QAction::triggered, &export_,
            &ExportController::askMeasurements);
    connect(actions[ui::Command::ExportTargetPoints], &QAction::triggered, &export_,
            &ExportController::askTargetPoints);
    connect(actions[ui::Command::ExportDeformed], &QAction::triggered, &export_, &ExportController::askDeformed);
    connect(actions[ui::Command::ExportMask], &QAction::triggered, &export_, &ExportController::askMask);
    connect(actions[ui::Command::ExportVessels], &QAction::triggered, this, [this] { save_.saveVessels(); });
    connect(&export_, &ExportController::started, this, [this] { notifications_.showNote(tr("Writing…")); });
    connect(&export_, &ExportController::exported, this, &SessionController::exported);
    connect(&export_, &ExportController::written, this,
            [this](const QString& path) { notifications_.showNote(tr("Saved: %1").arg(QFileInfo(path).fileName())); });
    const auto showFailure = [this](const QString& reason) {
        notifications_.showProblem(tr("Could not export"), reason);
    };
    connect(&export_, &ExportController::failed, this, showFailure);
    connect(&report_, &ReportController::failed, this, showFailure);
}

void SessionController::connectDicom()
{
    connect(ui_.actions[ui::Command::ExportDicom], &QAction::triggered, &dicom_, &DicomController::openDialog);
    connect(&dicom_, &DicomController::started, this, [this] { notifications_.showNote(tr("Writing…")); });
    connect(&dicom_, &DicomController::written, this, [this](const QString& folder, const QStringList& notes) {
        reportWritten(tr("DICOM objects written: %1").arg(QFileInfo(folder).fileName()), notes);
    });
    connect(&dicom_, &DicomController::failed, this,
            [this](const QString& reason) { notifications_.showProblem(tr("Could not export"), reason); });
}

/// Reports the file that was written, with remarks.
void SessionController::reportWritten(const QString& there, const QStringList& notes)
{
    if (notes.isEmpty()) {
        notifications_.showNote(there);
    } else {
        notifications_.showWarnings(ui::joinedSentences(QStringList{there} + notes));
    }
    emit exported();
}

void SessionController::connectPacking()
{
    connect(ui_.actions[ui::Command::ShareCase], &QAction::triggered, &pack_, &PackController::openDialog);
    connect(&pack_, &PackController::stopped, this,
            [this] { notifications_.showNote(tr("Stopped; nothing was written.")); });
    connect(&pack_, &PackController::written, this, [this](const QString& path, const QStringList& notes) {
        reportWritten(tr("Case bundle saved: %1").arg(QFileInfo(path).fileName()), notes);
    });
    connect(&pack_, &PackController::failed, this, [this](const QString& reason) {
        notifications_.showProblem(tr("Could not save the case bundle"), reason);
    });
}

void SessionController::connectArchives()
{
    connect(ui_.actions[ui::Command::QueryPacs], &QAction::triggered, archive_.get(), &ArchiveController::show);
    connect(archive_.get(), &ArchiveController::retrieved, &studies_, &StudyController::openFolders);
    connect(archive_.get(), &ArchiveController::reported, &notifications_, &Notifications::showNote);
    connect(ui_.actions[ui::Command::SendToArchive], &QAction::triggered, &dicom_,
            &DicomController::selectObjectsToSend);
    connect(&dicom_, &DicomController::wanted, this,
            [this](const ui::DicomExportOptions& choice) { sender_->openDialog(dicom_.makeWriter(choice)); });
    connect(sender_.get(), &ArchiveSender::sent, this, &SessionController::reportWritten);
}

void SessionController::connectDeidentifying()
{
    connect(ui_.actions[ui::Command::DeidentifyFiles], &QAction::triggered, &deidentify_,
            &DeidentifyController::openDialog);
    connect(&deidentify_, &DeidentifyController::written, this,
            [this](const QString&, const QString& words) { notifications_.showWarnings(words); });
    connect(&deidentify_, &DeidentifyController::partlyRejected, this,
            [this](const QString& words, const QString& lines) {
                ui::MessageDialog::show({tr("Some files were skipped"), words, lines}, &ui_.dialogParent);
            });
    connect(&deidentify_, &DeidentifyController::stopped, this,
            [this] { notifications_.showNote(tr("Stopped; nothing was written.")); });
    connect(&deidentify_, &DeidentifyController::failed, this, [this](const QString& reason) {
        notifications_.showProblem(tr("Could not de-identify the files"), reason);
    });
}

void SessionController::connectAudit(RegistrationController& registration)
{
    using io::AuditEvent;
    connect(&open_, &OpenController::opened, &audit_, &AuditController::noteOpened);
    connect(&save_, &SaveController::saved, &audit_, [this] { audit_.noteCase(AuditEvent::Saved); });
    connect(&registration, &RegistrationController::finished, &audit_,
            [this] { audit_.noteCase(AuditEvent::Registered); });
    connect(&export_, &ExportController::written, &audit_,
            [this](const QString& path) { audit_.note(AuditEvent::Exported, {path}); });
    connect(&dicom_, &DicomController::written, &audit_,
            [this](const QString& folder) { audit_.note(AuditEvent::Exported, {folder}); });
    connect(&pack_, &PackController::written, &audit_,
            [this](const QString& path) { audit_.note(AuditEvent::Packed, {path}); });
    connect(&deidentify_, &DeidentifyController::written, &audit_,
            [this](const QString& folder) { audit_.note(AuditEvent::Deidentified, {folder}); });
    connect(sender_.get(), &ArchiveSender::sent, &audit_, [this] { audit_.noteCase(AuditEvent::Sent); });
    const auto showIncomplete = [this](const QString& reason) {
        notifications_.showProblem(tr("The audit log is incomplete"), reason);
    };
    connect(&audit_, &AuditController::failed, this, showIncomplete);
    connect(archive_.get(), &ArchiveController::unaudited, this, showIncomplete);
}

/// Starts a separate process, so that a problem with one case cannot affect another.
void SessionController::openNewWindow()
{
    if (!QProcess::startDetached(QCoreApplication::applicationFilePath(), {})) {
        notifications_.showProblem(tr("Could not open another window"),
                                   tr("Could not start another AngioPose process. Start it from the system menu."));
    }
}

}   // namespace angiopose::app
