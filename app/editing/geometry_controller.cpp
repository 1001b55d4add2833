#include "app/editing/geometry_controller.h"

#include "app/document/edit_case.h"
#include "app/document/with_geometry.h"
#include "app/words/geometry_state.h"
#include "ui/panels/geometry_panel.h"

namespace angiopose::app {

GeometryController::GeometryController(CaseDocument& document, ui::GeometryPanel& panel, QObject* parent)
    : QObject(parent), document_(document), panel_(panel)
{
    connect(&panel, &ui::GeometryPanel::edited, this, &GeometryController::change);
    connect(&panel, &ui::GeometryPanel::cameraOverrideRemoved, this, &GeometryController::removeCameraOverride);
}

void GeometryController::show()
{
    panel_.showGeometry(geometryState(document_.current()));
}

void GeometryController::change(const core::CArm& cArm, const ui::LocalizedText& undoText)
{
    document_.push(changeGeometry(document_, replaceGeometry(document_.current(), cArm),
                                  [undoText] { return tr("Change %1").arg(undoText()); }));
}

void GeometryController::removeCameraOverride()
{
    core::Case newCase = document_.current();
    newCase.shown().geometry.cameraOverride.reset();
    core::discardResults(newCase.shown());
    document_.push(changeGeometry(document_, newCase, [] { return tr("Use distances and spacing"); }));
}

}   // namespace angiopose::app
