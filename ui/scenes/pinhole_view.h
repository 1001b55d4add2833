#pragma once

#include "core/geometry/projection_camera.h"
#include "core/geometry/rigid_transform.h"
#include "ui/scenes/view_rect.h"

class vtkCamera;

namespace angiopose::ui {

/// Points a VTK camera so that it sees what the X-ray source sees: a point in patient space (mm) falls on the pixel
/// that `core::project` gives, and the part `rect` of the image fills the picture.
void setPinhole(vtkCamera& view, const core::ProjectionCamera& camera, const core::RigidTransform& cameraFromPatient,
                const ViewRect& rect);

}   // namespace angiopose::ui
