#include "app/files/close_controller.h"

#include "app/window_layout.h"
#include "ui/dialogs/message_dialog.h"
#include "ui/main_window.h"

#include <utility>

namespace app {

CloseController::CloseController(ui::MainWindow& window, CaseDocument& document, SaveController& save,
                                 RegistrationController& registration, QObject* parent)
    : QObject(parent), window_(window), document_(document), save_(save), registration_(registration)
{
    connect(&window_, &ui::MainWindow::closeRequested, this, &CloseController::requestClose);
    connect(&registration_, &RegistrationController::runningChanged, this, [this](bool running) {
        if (!running && closing_ != Closing::No) {
            // The solver's best pose is applied by the same event: close once that is done.
            QMetaObject::invokeMethod(this, &CloseController::closeWindow, Qt::QueuedConnection);
        }
    });
}

void CloseController::requestClose()
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
    connect(question, &ui::QuestionDialog::answered, this, &CloseController::answerClose);
    question->open();
}

void CloseController::answerClose(int index)
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

void CloseController::closeWindow()
{
    if (std::exchange(closing_, Closing::No) == Closing::AfterSaving) {
        save_.save([this] { closeWindow(); });
        return;
    }
    save_.discardAutosave();
    storeWindowLayout(window_);
    window_.closeNow();
}

}   // namespace app
