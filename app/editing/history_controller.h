#pragma once

#include "app/document/case_document.h"

#include <QObject>

class QAction;

namespace angiopose::ui {
class MainWindow;
}

namespace angiopose::app {

/// Undo and redo: the commands, and the words they and the strip show.
class HistoryController : public QObject {
    Q_OBJECT
public:
    HistoryController(CaseDocument& document, ui::MainWindow& window, QObject* parent = nullptr);

private:
    void show();

    CaseDocument& document_;
    ui::MainWindow& window_;
};

}   // namespace angiopose::app