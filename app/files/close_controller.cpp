#include "app/files/close_controller.h"

#include "ui/actions/window_actions.h"
#include "ui/dialogs/message_dialog.h"

#include <algorithm>
#include <utility>

namespace angiopose::app {

CloseController::CloseController(CaseDocument& document, SaveController& save, RegistrationController& registration,
                                 const ui::WindowActions& actions, QWidget& dialogParent, QObject* parent)
    : QObject(parent),
      document_(document),
      saveController_(save),
      registration_(registration),
      dialogParent_(dialogParent)
{
    connect(actions[ui::Command::CloseCase], &QAction::triggered, this, [this] { requestClose(CloseTarget::Case); });
    connect(&registration_, &RegistrationController::runningChanged, this, [this](bool running) {
        if (!running && closing_ != Closing::No) {
            // The same event also applies the best pose of the solver, so close only afterward.
            QMetaObject::invokeMethod(this, &CloseController::close, Qt::QueuedConnection);
        }
    });
}

void CloseController::requestClose(CloseTarget closed)
{
    if (dialogParent_.findChild<QDialog*>(QStringLiteral("closeQuestion"))) {
        return;
    }
    target_ = closed;
    emit aboutToClose();
    if (!registration_.isRunning() && !saveController_.hasUnsavedWork()) {
        close();
        return;
    }
    const Question words = question();
    QStringList verbs;
    for (const auto& [verb, closing] : words.answers) {
        verbs << verb;
    }
    auto* dialog = new ui::QuestionDialog(words.message, verbs, &dialogParent_);
    dialog->setObjectName(QStringLiteral("closeQuestion"));
    const auto stays = std::ranges::find(words.answers, Closing::No, &std::pair<QString, Closing>::second);
    dialog->setAnswerOnClose(static_cast<int>(stays - words.answers.begin()));
    connect(
        dialog, &ui::QuestionDialog::answered, this,
        [this, answers = words.answers](int index) { answerClose(answers.at(static_cast<std::size_t>(index)).second); },
        Qt::QueuedConnection);   // queued: this dialog closes before another one opens
    dialog->open();
}

CloseController::Question CloseController::question() const
{
    using enum Closing;
    if (registration_.isRunning()) {
        return {
            {tr("A registration is running"), tr("Stop it and close? Unsaved changes to this case will be lost."), {}},
            {{tr("Stop, save and close"), AfterSaving}, {tr("Stop and close"), Now}, {tr("Keep running"), No}}};
    }
    const QString title = QString::fromStdString(document_.current().title);
    switch (saveController_.savable()) {
        case SaveController::Savable::Case:
            break;
        case SaveController::Savable::Vessels:
            return {
                {tr("Save before closing?"),
                 tr("“%1” has no angiogram yet. Only its vessels can be saved, as centerlines.").arg(title),
                 {}},
                {{tr("Save vessels and close"), AfterSaving}, {tr("Close without saving"), Now}, {tr("Cancel"), No}}};
        case SaveController::Savable::Nothing:
            return {{tr("Close without saving?"),
                     tr("“%1” has no vessels yet, so there is no case to save. Unsaved work will be lost.").arg(title),
                     {}},
                    {{tr("Cancel"), No}, {tr("Close without saving"), Now}}};
    }
    return {{tr("Save before closing?"), tr("“%1” has unsaved changes.").arg(title), {}},
            {{tr("Save and close"), AfterSaving}, {tr("Close without saving"), Now}, {tr("Cancel"), No}}};
}

void CloseController::answerClose(Closing closing)
{
    if (closing == Closing::No) {
        return;
    }
    closing_ = closing;
    if (registration_.isRunning()) {
        registration_.stop();   // the slot of runningChanged closes the window once the worker has finished
    } else {
        close();
    }
}

void CloseController::close()
{
    if (std::exchange(closing_, Closing::No) == Closing::AfterSaving) {
        // Edits made during saving are not in the file, so ask again instead of discarding them.
        const auto goOn = [this] { saveController_.hasUnsavedWork() ? requestClose(target_) : close(); };
        if (saveController_.savable() == SaveController::Savable::Vessels) {
            saveController_.saveVessels(goOn);
        } else {
            saveController_.save(goOn);
        }
        return;
    }
    saveController_.discardAutosave();
    if (target_ == CloseTarget::Case) {
        document_.replace({}, {});
        return;
    }
    emit windowMayClose();
}

}   // namespace angiopose::app
