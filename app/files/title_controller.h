#pragma once

#include "app/document/case_document.h"
#include "app/files/save_controller.h"

#include <QObject>
#include <QTimer>

class QWidget;

namespace angiopose::ui {
class BottomStrip;
class HeaderBar;
}   // namespace angiopose::ui

namespace angiopose::app {

/// Shows the open case, its study and its save state in the title bar, the header and the status strip.
class TitleController : public QObject {
    Q_OBJECT
public:
    TitleController(CaseDocument& document, SaveController& saveController, ui::HeaderBar& header,
                    ui::BottomStrip& strip, QWidget& window, QObject* parent = nullptr);

private:
    void show();
    void showSaveState();
    QString studyText() const;

    CaseDocument& document_;
    SaveController& saveController_;
    ui::HeaderBar& header_;
    ui::BottomStrip& strip_;
    QWidget& window_;
    QTimer clock_;   ///< refreshes strings such as "Autosaved 12 s ago"
};

}   // namespace angiopose::app
