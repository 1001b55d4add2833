#include "app/editing/geometry_controller.h"

#include "app/document/edit_case.h"
#include "app/document/with_geometry.h"
#include "app/words/geometry_state.h"
#include "ui/main_window.h"

namespace angiopose::app {

GeometryController::GeometryController(CaseDocument& document, ui::MainWindow& window, QObject* parent)
    : QObject(parent), document_(document), window_(window)
{
    const ui::GeometryPanel& panel = window.geometryPanel();
    connect(&panel, &ui::GeometryPanel::edited, this, &GeometryController::change);
    connect(&panel, &ui::GeometryPanel::cameraOverrideDropped, this, &GeometryController::dropCameraOverride);
}

void GeometryController::show()
{
    window_.geometryPanel().showGeometry(geometryState(document_.current()));
}

void GeometryController::change(const core::CArm& cArm, const ui::Words& what)
{
    document_.push(changeGeometry(document_, withGeometry(document_.current(), cArm),
                                  [what] { return tr("Change %1").arg(what()); }));
}

void GeometryController::dropCameraOverride()
{
    core::Case wanted = document_.current();
    wanted.shown().geometry.cameraOverride.reset();
    wanted.shown().result.reset();
    document_.push(changeGeometry(document_, wanted, [] { return tr("Use distances and spacing"); }));
}

}   // namespace angiopose::app