#pragma once

#include "app/document/case_document.h"
#include "app/files/save_controller.h"
#include "app/registration/registration_controller.h"

#include "ui/dialogs/message_dialog.h"

#include <QObject>

#include <utility>
#include <vector>

namespace angiopose::ui {
class MainWindow;
}

namespace angiopose::app {

/// Closing the window or the case alone loses nothing unasked: neither changes nor a running registration, whose best
/// pose is kept before saving.
class CloseController : public QObject {
    Q_OBJECT
public:
    CloseController(ui::MainWindow& window, CaseDocument& document, SaveController& save,
                    RegistrationController& registration, QObject* parent = nullptr);

signals:
    void aboutToClose();   ///< the user asked for it; what must not stay open ends now

private:
    enum class Closing { No, Now, AfterSaving };
    enum class Closed { Window, Case };

    struct Question {
        ui::Message message;
        std::vector<std::pair<QString, Closing>> answers;   ///< the first one stands out
    };

    void requestClose(Closed closed);
    Question question() const;
    void answerClose(Closing closing);
    void close();

    ui::MainWindow& window_;
    CaseDocument& document_;
    SaveController& save_;
    RegistrationController& registration_;
    Closing closing_ = Closing::No;
    Closed closed_ = Closed::Window;   ///< what is being closed
};

}   // namespace angiopose::app