#include "app/files/privacy_controller.h"

#include "app/files/recent_cases.h"
#include "app/preferences/private_mode.h"
#include "app/preferences/settings.h"
#include "ui/dialogs/message_dialog.h"
#include "ui/words/spoken.h"

#include <QAction>

namespace angiopose::app {

PrivacyController::PrivacyController(QAction& mode, QWidget& dialogParent, QObject* parent)
    : QObject(parent), mode_(mode), dialogParent_(dialogParent)
{
    mode_.setChecked(isPrivate());
    ui::withTip(&mode_, [] {
        return tr("No list and no pictures of recent cases, no names in the title, no folders remembered.");
    });
    connect(&mode_, &QAction::triggered, this, &PrivacyController::choose);
}

PrivacyController::~PrivacyController()
{
    if (isPrivate()) {
        forgetFileDialogs();
    }
}

void PrivacyController::choose(bool on)
{
    if (!on) {
        turnOff();
        return;
    }
    auto* question = new ui::QuestionDialog(
        {tr("Turn private mode on?"),
         tr("The list of recent cases, pinned ones too, their pictures and the folders and names remembered so far are "
            "forgotten for good. Nothing of the kind is kept until private mode is turned off. Automatic copies of "
            "unsaved work are still made, and removed when a case is closed."),
         {}},
        {tr("Turn on"), tr("Cancel")}, &dialogParent_);
    question->setObjectName(QStringLiteral("privacyDialog"));
    connect(question, &ui::QuestionDialog::answered, this, [this](int verb) {
        if (verb == 0) {
            turnOn();
        } else {
            mode_.setChecked(false);
        }
    });
    question->open();
}

void PrivacyController::turnOn()
{
    settings::privateMode.write(true);
    forgetTraces();
    keepCasePictures({});
    ui::speakAgain();
    emit changed();
}

void PrivacyController::turnOff()
{
    settings::privateMode.write(false);
    ui::speakAgain();
    emit changed();
}

}   // namespace angiopose::app
