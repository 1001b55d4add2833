#pragma once

#include "app/document/case_document.h"

#include <QObject>

class QAction;

namespace angiopose::ui {
class BottomStrip;
class WindowActions;
}   // namespace angiopose::ui

namespace angiopose::app {

/// Manages undo and redo, and the names of edits in their commands and in the status strip.
class HistoryController : public QObject {
    Q_OBJECT
public:
    HistoryController(CaseDocument& document, ui::WindowActions& actions, ui::BottomStrip& strip,
                      QObject* parent = nullptr);

private:
    void show();

    CaseDocument& document_;
    ui::WindowActions& actions_;
    ui::BottomStrip& strip_;
};

}   // namespace angiopose::app
