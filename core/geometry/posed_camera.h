#pragma once

#include "core/geometry/projection_camera.h"
#include "core/geometry/rigid_transform.h"

namespace angiopose::core {

/// Projection of the patient into an image: the camera and its pose.
struct PosedCamera {
    ProjectionCamera camera;
    RigidTransform cameraFromPatient;
};

}   // namespace angiopose::core
