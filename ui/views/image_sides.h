#pragma once

#include "core/geometry/projection_camera.h"
#include "core/geometry/rigid_transform.h"

#include <string>

namespace angiopose::ui {

/// The patient's side that each edge of the image shows: L, R, A, P, H (head), F (feet), or two of them, the stronger
/// first, where the image lies askew.
struct ImageSides {
    std::string left, right, top, bottom;
};

/// Patient coordinates are LPS; a mirrored image (negative focal length) has its letters swapped.
ImageSides imageSides(const core::ProjectionCamera& camera, const core::RigidTransform& cameraFromPatient);

}   // namespace angiopose::ui