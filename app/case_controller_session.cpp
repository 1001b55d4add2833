#include "app/case_controller.h"

#include "app/files/recent_cases.h"
#include "app/files/sample_case.h"
#include "app/files/series_rows.h"
#include "app/jobs/input_kind.h"
#include "app/settings.h"
#include "ui/dialogs/key_sheet.h"
#include "ui/dialogs/message_dialog.h"

#include <QCoreApplication>
#include <QFileDialog>

// From the first start to the last window: notice, opening, recovery, closing, help.

namespace app {
namespace {

/// Asks for a folder of DICOM files.
QFileDialog* makeFolderDialog(QWidget* window)
{
    auto* dialog = new QFileDialog(window, CaseController::tr("Open DICOM folder"), settings::lastFolder.read());
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setFileMode(QFileDialog::Directory);
    dialog->setOption(QFileDialog::ShowDirsOnly);
    return dialog;
}

}   // namespace

void CaseController::begin(const QStringList& paths)
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

void CaseController::showNotice()
{
    auto* notice = new ui::QuestionDialog(
        {tr("Not for clinical use"),
         tr("AngioPose is a research program. It is not a medical device: do not use it for diagnosis, treatment or "
            "navigation. Results can be wrong; one projection cannot tell everything about depth."),
         {}},
        {tr("I understand")}, &window_);
    notice->setObjectName(QStringLiteral("noticeDialog"));
    connect(notice, &ui::QuestionDialog::answered, this, [] { settings::noticeAccepted.write(true); });
    notice->open();
}

void CaseController::connectFiles()
{
    ui::WindowActions& actions = window_.actions();
    connect(&window_, &ui::MainWindow::filesDropped, this, &CaseController::open);
    connect(&window_, &ui::MainWindow::closeRequested, this, &CaseController::requestClose);
    connect(&window_.welcome(), &ui::WelcomePage::openRequested, this, &CaseController::askFiles);
    connect(&window_.welcome(), &ui::WelcomePage::sampleRequested, this, &CaseController::openSample);
    connect(&window_.welcome(), &ui::WelcomePage::recentRequested, this, [this](const QString& path) { open({path}); });
    connect(actions[ui::Command::Open], &QAction::triggered, this, &CaseController::askFiles);
    connect(actions[ui::Command::OpenFolder], &QAction::triggered, this, [this] {
        QFileDialog* dialog = makeFolderDialog(&window_);
        connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& folder) {
            settings::lastFolder.write(folder);
            open({folder});
        });
        dialog->open();
    });
    connect(actions[ui::Command::OpenSample], &QAction::triggered, this, &CaseController::openSample);
    connect(actions[ui::Command::Save], &QAction::triggered, this, [this] { save_.save(); });
    connect(actions[ui::Command::SaveAs], &QAction::triggered, this, [this] { save_.saveAs(); });
    connect(actions[ui::Command::Close], &QAction::triggered, &window_, &QWidget::close);
    connect(actions[ui::Command::ExportOverlay], &QAction::triggered, &export_, &ExportController::askOverlay);
    connect(actions[ui::Command::ExportResult], &QAction::triggered, &export_, &ExportController::askResult);
    connect(actions[ui::Command::ExportPose], &QAction::triggered, &export_, &ExportController::askPose);
    connect(actions[ui::Command::ExportTrace], &QAction::triggered, &export_, &ExportController::askTrace);

    connect(&open_, &OpenController::started, this, [this](const QString& what) { window_.strip().showBusy(what); });
    connect(&open_, &OpenController::advanced, this, [this](const QString& what, double fraction) {
        if (fraction > 0.0) {
            window_.strip().showProgress(what, fraction);
        }
    });
    connect(&open_, &OpenController::seriesChoiceNeeded, this,
            [this](const QString& folder, const std::vector<io::DicomSeries>& series) {
                auto* chooser = new ui::SeriesChooser(folder, seriesRows(series), &window_);
                connect(chooser, &ui::SeriesChooser::chosen, &open_, &OpenController::openSeries);
                chooser->open();
            });
    connect(&open_, &OpenController::ended, this, [this] { window_.strip().showIdle(tr("Ready")); });
    connect(&open_, &OpenController::opened, this, [this](const QStringList& notes) {
        if (recovering_) {
            recovering_ = false;
            document_.markUnsaved();
        }
        fillRecent();
        showNote(notes.isEmpty() ? tr("Opened") : notes.join(QLatin1Char(' ')));
    });
    connect(&open_, &OpenController::failed, this, [this](const QString& reason, const QStringList& paths) {
        recovering_ = false;
        showProblem(paths.size() == 1 ? tr("Could not open the file") : tr("Could not open the files"), reason, paths);
    });
    connect(&open_, &OpenController::replacementNeedsConsent, this, &CaseController::askToReplace);
    connect(&save_, &SaveController::failed, this,
            [this](const QString& reason) { showProblem(tr("Could not save"), reason, {document_.path()}); });
    connect(&save_, &SaveController::started, this, [this] { showNote(tr("Saving …")); });
    connect(&save_, &SaveController::saved, this, [this] {
        fillRecent();
        showNote(tr("Saved"));
    });
    connect(&save_, &SaveController::recoveryWanted, this, [this](const LeftBehind& copy) {
        recovering_ = true;
        open({copy.path});
    });
    connect(&export_, &ExportController::started, this, [this] { showNote(tr("Writing …")); });
    connect(&export_, &ExportController::exported, this, [this](const QString& path) {
        exported_ = true;
        showSteps();
        showNote(tr("Written: %1").arg(QFileInfo(path).fileName()));
    });
    connect(&export_, &ExportController::failed, this,
            [this](const QString& reason) { showProblem(tr("Could not export"), reason); });
}

void CaseController::askFiles()
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

void CaseController::openSample()
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
            showProblem(tr("Could not make the sample case"), QString::fromStdString(path.error().message));
        }
    });
}

void CaseController::askToReplace()
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

void CaseController::requestClose()
{
    if (window_.findChild<QDialog*>(QStringLiteral("closeQuestion"))) {
        return;
    }
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
    connect(question, &ui::QuestionDialog::answered, this, &CaseController::answerClose);
    question->open();
}

void CaseController::answerClose(int index)
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

void CaseController::closeWindow()
{
    if (std::exchange(closing_, Closing::No) == Closing::AfterSaving) {
        save_.save([this] { closeWindow(); });
        return;
    }
    save_.discardAutosave();
    settings::windowLayout.write(window_.layoutState());
    window_.closeNow();
}

void CaseController::connectHelp()
{
    ui::WindowActions& actions = window_.actions();
    connect(actions[ui::Command::Keys], &QAction::triggered, this, [this] {
        auto* sheet = new ui::KeySheet(window_.actions().keySheet(), &window_);
        sheet->open();
    });
    connect(actions[ui::Command::About], &QAction::triggered, this, [this] {
        ui::MessageDialog::show(
            {tr("AngioPose %1").arg(QCoreApplication::applicationVersion()),
             tr("Finds where a 3-D vessel tree lies in a 2-D angiogram, without correspondences.\n\n"
                "Not for clinical use: AngioPose is a research program, not a medical device.\n\n"
                "Apache License 2.0. Built on Qt, VTK, ITK, OpenCV, NLopt, Eigen and nanoflann."),
             {}},
            &window_);
    });
    connect(&window_.steps(), &ui::StepBar::stepClicked, &window_, &ui::MainWindow::focusStep);
}

}   // namespace app
