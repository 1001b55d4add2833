#include "app/files/session_controller.h"

#include "app/files/recent_cases.h"
#include "app/files/sample_case.h"
#include "app/files/series_rows.h"
#include "app/jobs/input_kind.h"
#include "app/settings.h"
#include "app/window_layout.h"
#include "core/imaging/patient_match.h"
#include "ui/dialogs/message_dialog.h"
#include "ui/dialogs/missing_inputs.h"
#include "ui/main_window.h"
#include "ui/words/core_texts.h"

#include <QFileDialog>

namespace app {

SessionController::SessionController(ui::MainWindow& window, CaseDocument& document, TargetProvider& target,
                                     RegistrationController& registration, Notices& notices, QObject* parent)
    : QObject(parent),
      window_(window),
      document_(document),
      registration_(registration),
      notices_(notices),
      open_(document),
      save_(document, window),
      export_(document, target, window)
{
    connectFiles();
    connectOpening();
    connectSaving();
    connectExporting();
    connect(&registration_, &RegistrationController::runningChanged, this, [this](bool running) {
        if (!running && closing_ != Closing::No) {
            // The solver's best pose is applied by the same event: close once that is done.
            QMetaObject::invokeMethod(this, &SessionController::closeWindow, Qt::QueuedConnection);
        }
    });
    fillRecent();
}

void SessionController::warnOfMismatch()
{
    const core::RegistrationCase& current = document_.current();
    const std::string mismatch =
        current.angiogram ? core::findMismatch(current.scanIdentity, current.angiogram->identity) : "";
    if (!mismatch.empty()) {
        notices_.showProblem(tr("Not the same patient?"), QString::fromStdString(mismatch));
    }
}

void SessionController::begin(const QStringList& paths)
{
    if (!settings::noticeAccepted.read()) {
        showNotice();
    }
    if (!paths.isEmpty()) {
        QStringList absolute;
        for (const QString& path : paths) {
            absolute << QFileInfo(path).absoluteFilePath();
        }
        open(absolute);
    } else {
        save_.offerRecovery();
    }
}

void SessionController::showNotice()
{
    auto* notice = new ui::QuestionDialog(
        {tr("Not for clinical use"),
         tr("AngioPose is a research program. It is not a medical device: do not use it for diagnosis, treatment or "
            "navigation. Results can be wrong; one projection cannot tell everything about depth."),
         {}},
        {tr("I understand")}, &window_);
    notice->setObjectName(QStringLiteral("noticeDialog"));
    connect(notice, &ui::QuestionDialog::answered, this, [this] {
        settings::noticeAccepted.write(true);
        emit noticeAccepted();
    });
    notice->open();
}

void SessionController::connectFiles()
{
    ui::WindowActions& actions = window_.actions();
    connect(&window_, &ui::MainWindow::filesDropped, this, &SessionController::open);
    connect(&window_, &ui::MainWindow::closeRequested, this, &SessionController::requestClose);
    connect(&window_.welcome(), &ui::WelcomePage::openRequested, this, &SessionController::askFiles);
    connect(&window_.welcome(), &ui::WelcomePage::sampleRequested, this, &SessionController::openSample);
    connect(&window_.welcome(), &ui::WelcomePage::recentRequested, this, [this](const QString& path) { open({path}); });
    connect(actions[ui::Command::Open], &QAction::triggered, this, &SessionController::askFiles);
    connect(actions[ui::Command::OpenFolder], &QAction::triggered, this, &SessionController::askFolder);
    connect(actions[ui::Command::OpenSample], &QAction::triggered, this, &SessionController::openSample);
    connect(actions[ui::Command::Close], &QAction::triggered, &window_, &QWidget::close);
}

void SessionController::connectOpening()
{
    connect(&open_, &OpenController::started, this, [this](const QString& what) { window_.strip().showBusy(what); });
    connect(&open_, &OpenController::advanced, this, [this](const QString& what, double fraction) {
        if (fraction > 0.0) {
            window_.strip().showProgress(what, fraction);
        }
    });
    connect(&open_, &OpenController::seriesChoiceNeeded, this, &SessionController::chooseSeries);
    connect(&open_, &OpenController::inputsMissing, this, &SessionController::askForInputs);
    connect(&open_, &OpenController::ended, this, [this] { window_.strip().showIdle(tr("Ready")); });
    connect(&open_, &OpenController::opened, this, [this](const QStringList& notes) {
        save_.noteOpened(open_.openedCopy());
        fillRecent();
        notices_.showNote(notes.isEmpty() ? tr("Opened") : notes.join(QLatin1Char(' ')));
        warnOfMismatch();
    });
    connect(&open_, &OpenController::failed, this, [this](const QString& reason, const QStringList& paths) {
        notices_.showProblem(paths.size() == 1 ? tr("Could not open the file") : tr("Could not open the files"), reason,
                             paths);
    });
    connect(&open_, &OpenController::scanChoiceNeeded, this, &SessionController::askWhatScan);
    connect(&open_, &OpenController::viewChoiceNeeded, this, &SessionController::askWhichView);
    connect(window_.actions()[ui::Command::AddView], &QAction::triggered, this, &SessionController::askView);
    connect(&open_, &OpenController::replacementNeedsConsent, this, &SessionController::askToReplace);
}

void SessionController::connectSaving()
{
    ui::WindowActions& actions = window_.actions();
    connect(actions[ui::Command::Save], &QAction::triggered, this, [this] { save_.save(); });
    connect(actions[ui::Command::SaveAs], &QAction::triggered, this, [this] { save_.saveAs(); });
    connect(&save_, &SaveController::failed, this,
            [this](const QString& reason) { notices_.showProblem(tr("Could not save"), reason, {document_.path()}); });
    connect(&save_, &SaveController::started, this, [this] { notices_.showNote(tr("Saving …")); });
    connect(&save_, &SaveController::saved, this, [this] {
        fillRecent();
        notices_.showNote(tr("Saved"));
    });
    connect(&save_, &SaveController::recoveryWanted, this,
            [this](const LeftBehind& copy) { open_.openCopy(copy.path, copy.original); });
}

void SessionController::connectExporting()
{
    ui::WindowActions& actions = window_.actions();
    connect(actions[ui::Command::ExportOverlay], &QAction::triggered, &export_, &ExportController::askOverlay);
    connect(actions[ui::Command::ExportResult], &QAction::triggered, &export_, &ExportController::askResult);
    connect(actions[ui::Command::ExportPose], &QAction::triggered, &export_, &ExportController::askPose);
    connect(actions[ui::Command::ExportTrace], &QAction::triggered, &export_, &ExportController::askTrace);
    connect(&export_, &ExportController::started, this, [this] { notices_.showNote(tr("Writing …")); });
    connect(&export_, &ExportController::exported, this, [this](const QString& path) {
        emit exported();
        notices_.showNote(tr("Written: %1").arg(QFileInfo(path).fileName()));
    });
    connect(&export_, &ExportController::failed, this,
            [this](const QString& reason) { notices_.showProblem(tr("Could not export"), reason); });
}

void SessionController::askFiles()
{
    auto* dialog =
        new QFileDialog(&window_, tr("Open"), settings::lastFolder.read(), openFilters().join(QStringLiteral(";;")));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setFileMode(QFileDialog::ExistingFiles);
    connect(dialog, &QFileDialog::filesSelected, this, [this](const QStringList& paths) {
        settings::lastFolder.write(QFileInfo(paths.front()).absolutePath());
        open(paths);
    });
    dialog->open();
}

void SessionController::askFolder()
{
    auto* dialog = new QFileDialog(&window_, tr("Open DICOM folder"), settings::lastFolder.read());
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setFileMode(QFileDialog::Directory);
    dialog->setOption(QFileDialog::ShowDirsOnly);
    connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& folder) {
        settings::lastFolder.write(folder);
        open({folder});
    });
    dialog->open();
}

void SessionController::chooseSeries(const QString& folder, const std::vector<io::DicomSeries>& series)
{
    auto* chooser = new ui::SeriesChooser(folder, seriesRows(series), &window_);
    connect(chooser, &ui::SeriesChooser::chosen, &open_, &OpenController::openSeries);
    chooser->open();
}

void SessionController::askView()
{
    auto* dialog = new QFileDialog(&window_, tr("Add a view"), settings::lastFolder.read(),
                                   openFilters().join(QStringLiteral(";;")));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setFileMode(QFileDialog::ExistingFile);
    connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& path) {
        settings::lastFolder.write(QFileInfo(path).absolutePath());
        open_.openView({path});
    });
    dialog->open();
}

void SessionController::askWhichView(const QString& name)
{
    auto* question = new ui::QuestionDialog(
        {tr("Another view of the same vessels?"),
         tr("The case has an angiogram. “%1” can stand beside it, to register both together, or take its place.")
             .arg(name),
         {}},
        {tr("Add as a view"), tr("Replace the angiogram"), tr("Cancel")}, &window_);
    question->setObjectName(QStringLiteral("viewQuestion"));
    connect(question, &ui::QuestionDialog::answered, this, [this](int index) {
        if (index == 0) {
            open_.addWaitingView();
        } else if (index == 1) {
            open_.replaceImage();
        } else {
            open_.abandon();
        }
    });
    question->open();
}

void SessionController::askWhatScan(const QString& name)
{
    auto* question =
        new ui::QuestionDialog({tr("A scan beside the vessels?"),
                                tr("The case has its vessels from a file. “%1” can be shown in slices with them, or "
                                   "its own vessels are traced "
                                   "and take their place.")
                                    .arg(name),
                                {}},
                               {tr("Show beside the vessels"), tr("Trace its vessels"), tr("Cancel")}, &window_);
    question->setObjectName(QStringLiteral("scanQuestion"));
    connect(question, &ui::QuestionDialog::answered, this, [this](int index) {
        if (index < 2) {
            open_.openScan(index == 0 ? ScanUse::Beside : ScanUse::Trace);
        }
    });
    question->open();
}

void SessionController::askForInputs(const QString& casePath, const QStringList& missing, bool areOptional)
{
    const QFileInfo file(casePath);
    auto* dialog = new ui::MissingInputs(file.fileName(), missing, file.absolutePath(), &window_);
    dialog->offerWithout(areOptional);
    connect(dialog, &ui::MissingInputs::withoutRequested, &open_, &OpenController::openWithoutOptional);
    connect(dialog, &ui::MissingInputs::located, this, [this](const std::map<QString, QString>& places) {
        io::MovedInputs moved;
        for (const auto& [wanted, place] : places) {
            moved[wanted.toStdString()] = place.toStdString();
        }
        open_.openWithInputs(moved);
    });
    connect(dialog, &ui::MissingInputs::searchRequested, this,
            [this](const QString& folder) { open_.openWithInputs({}, folder); });
    dialog->open();
}

void SessionController::openSample()
{
    if (files_.isBusy()) {
        return;
    }
    window_.strip().showBusy(tr("Making the sample case …"));
    files_.run(writeSampleCase, [this](const core::Result<QString>& path) {
        window_.strip().showIdle(tr("Ready"));
        if (path) {
            open({path.value()});
        } else {
            notices_.showProblem(tr("Could not make the sample case"), ui::coreText(path.error().message));
        }
    });
}

void SessionController::askToReplace()
{
    auto* question = new ui::QuestionDialog(
        {tr("Save the open case first?"),
         tr("“%1” has changes that are not saved.").arg(QString::fromStdString(document_.current().title)),
         {}},
        {tr("Save"), tr("Discard changes"), tr("Keep the open case")}, &window_);
    connect(question, &ui::QuestionDialog::answered, this, [this](int index) {
        if (index == 0) {
            save_.save([this] { open_.replaceOpenCase(); });
        } else if (index == 1) {
            open_.replaceOpenCase();
        } else {
            open_.abandon();
        }
    });
    question->open();
}

void SessionController::requestClose()
{
    if (window_.findChild<QDialog*>(QStringLiteral("closeQuestion"))) {
        return;
    }
    emit aboutToClose();
    const bool running = registration_.isRunning();
    if (!running && !document_.isModified()) {
        closeWindow();
        return;
    }
    const ui::Message words =
        running ? ui::Message{tr("A registration is running"),
                              tr("Stop it and close? Changes of this case are lost unless they are saved."),
                              {}}
                : ui::Message{
                      tr("Save before closing?"),
                      tr("“%1” has changes that are not saved.").arg(QString::fromStdString(document_.current().title)),
                      {}};
    const QStringList verbs = running
                                  ? QStringList{tr("Stop, save and close"), tr("Stop and close"), tr("Keep running")}
                                  : QStringList{tr("Save and close"), tr("Close without saving"), tr("Stay")};
    auto* question = new ui::QuestionDialog(words, verbs, &window_);
    question->setObjectName(QStringLiteral("closeQuestion"));
    connect(question, &ui::QuestionDialog::answered, this, &SessionController::answerClose);
    question->open();
}

void SessionController::answerClose(int index)
{
    if (index == 2) {
        return;
    }
    closing_ = index == 0 ? Closing::AfterSaving : Closing::Now;
    if (registration_.isRunning()) {
        registration_.stop();   // setRunning goes on when the worker has ended
    } else {
        closeWindow();
    }
}

void SessionController::closeWindow()
{
    if (std::exchange(closing_, Closing::No) == Closing::AfterSaving) {
        save_.save([this] { closeWindow(); });
        return;
    }
    save_.discardAutosave();
    storeWindowLayout(window_);
    window_.closeNow();
}

void SessionController::fillRecent()
{
    QMenu* menu = window_.actions().recentMenu();
    menu->clear();
    for (const QString& path : recentCases()) {
        const QFileInfo file(path);
        const bool missing = !file.exists();
        QAction* action = menu->addAction(missing ? tr("%1 (missing)").arg(file.fileName()) : file.fileName());
        action->setToolTip(path);
        action->setEnabled(!missing);
        connect(action, &QAction::triggered, this, [this, path] { open({path}); });
    }
    menu->setEnabled(!menu->isEmpty());
    window_.welcome().showRecent(recentCases());
}

}   // namespace app
