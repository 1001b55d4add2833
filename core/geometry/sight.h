#pragma once

#include "core/geometry/projection_camera.h"
#include "core/geometry/rigid_transform.h"

namespace angiopose::core {

/// How the patient is seen in an image: by what camera, and where that stands.
struct Sight {
    ProjectionCamera camera;
    RigidTransform cameraFromPatient;
};

}   // namespace angiopose::core
