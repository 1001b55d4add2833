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

void GeometryController::change(const core::CArm& cArm, const ui::LocalizedText& what)
{
    document_.push(changeGeometry(document_, withGeometry(document_.current(), cArm),
                                  [what] { return tr("Change %1").arg(what()); }));
}

void GeometryController::removeCameraOverride()
{
    core::Case wanted = document_.current();
    wanted.shown().geometry.cameraOverride.reset();
    core::discardResults(wanted.shown());
    document_.push(changeGeometry(document_, wanted, [] { return tr("Use distances and spacing"); }));
}

}   // namespace angiopose::app
