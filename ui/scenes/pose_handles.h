#pragma once

#include "ui/scenes/stroke_mesh.h"

namespace ui {

enum class PoseHandle { None, Shift, Roll };

/// What the handles look like at this moment; lengths in device px, y up.
struct PoseHandleLook {
    Eigen::Vector2d centre = Eigen::Vector2d::Zero();
    double radius = 0.0;   ///< of the roll ring; 0 hides everything
    double pixelScale = 1.0;
    PoseHandle hot = PoseHandle::None;   ///< under the mouse
    PoseHandle active = PoseHandle::None;   ///< being dragged
    double rollStartRad = 0.0;   ///< counter-clockwise from the right
    double rollSweepRad = 0.0;
};

/// Cross and ring by which the pose is grasped on the image.
StrokeMesh poseHandleStrokes(const PoseHandleLook& look);

}   // namespace ui
