#pragma once

#include "app/document/case_document.h"
#include "app/files/save_controller.h"
#include "app/registration/registration_controller.h"

#include "ui/dialogs/message_dialog.h"

#include <QObject>

#include <utility>
#include <vector>

class QWidget;

namespace angiopose::ui {
class WindowActions;
}   // namespace angiopose::ui

namespace angiopose::app {

/// Closes the window or the case. Asks the user before unsaved changes or a running registration are lost. Before
/// saving, applies the best pose of a running registration.
class CloseController : public QObject {
    Q_OBJECT
public:
    CloseController(CaseDocument& document, SaveController& save, RegistrationController& registration,
                    const ui::WindowActions& actions, QWidget& dialogParent, QObject* parent = nullptr);

    void closeWindow() { requestClose(CloseTarget::Window); }

signals:
    void aboutToClose();   ///< emitted when the user requests closing; receivers close what must not stay open
    void windowMayClose();   ///< emitted when the window can close without losing data

private:
    enum class Closing { No, Now, AfterSaving };
    enum class CloseTarget { Window, Case };

    struct Question {
        ui::Message message;
        std::vector<std::pair<QString, Closing>> answers;   ///< the first answer is the default
    };

    void requestClose(CloseTarget closed);
    Question question() const;
    void answerClose(Closing closing);
    void close();

    CaseDocument& document_;
    SaveController& saveController_;
    RegistrationController& registration_;
    QWidget& dialogParent_;
    Closing closing_ = Closing::No;
    CloseTarget target_ = CloseTarget::Window;   ///< window or case being closed
};

}   // namespace angiopose::app
