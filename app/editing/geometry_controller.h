#pragma once

#include "app/document/case_document.h"
#include "ui/words/retranslation.h"

#include <QObject>

namespace angiopose::ui {
class GeometryPanel;
}   // namespace angiopose::ui

namespace angiopose::app {

/// Manages the geometry panel: shows the values of the case with their origins and makes each edit an undo step.
class GeometryController : public QObject {
    Q_OBJECT
public:
    GeometryController(CaseDocument& document, ui::GeometryPanel& panel, QObject* parent = nullptr);

    void show();

private:
    void change(const core::CArm& cArm, const ui::LocalizedText& undoText);
    void removeCameraOverride();

    CaseDocument& document_;
    ui::GeometryPanel& panel_;
};

}   // namespace angiopose::app
