#pragma once

#include "app/document/case_document.h"
#include "ui/words/spoken.h"

#include <QObject>

namespace angiopose::ui {
class MainWindow;
}

namespace angiopose::app {

/// The geometry panel: shows the case's values with their origins, turns edits into undoable changes.
class GeometryController : public QObject {
    Q_OBJECT
public:
    GeometryController(CaseDocument& document, ui::MainWindow& window, QObject* parent = nullptr);

    void show();

private:
    void change(const core::CArm& cArm, const ui::Words& what);
    void dropCameraOverride();

    CaseDocument& document_;
    ui::MainWindow& window_;
};

}   // namespace angiopose::app