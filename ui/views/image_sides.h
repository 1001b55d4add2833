#pragma once

#include "core/geometry/projection_camera.h"
#include "core/geometry/rigid_transform.h"

#include <string>

namespace angiopose::ui {

/// Orientation letters at the edges of the image: L, R, A, P, H (head), F (feet), or two letters in oblique views,
/// dominant direction first.
struct ImageSides {
    std::string left, right, top, bottom;
};

/// Returns the sides for LPS patient coordinates; a mirrored image (negative focal length) has its letters swapped.
ImageSides imageSides(const core::ProjectionCamera& camera, const core::RigidTransform& cameraFromPatient);

}   // namespace angiopose::ui
