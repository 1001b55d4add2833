#pragma once

#include "ui/scenes/stroke_mesh.h"

namespace angiopose::ui {

enum class PoseHandle { None, Shift, Roll, LaoRao, CraCau, Depth };

/// Handles around the roll ring: LAO/RAO below it, CRA/CAU at its right, depth at its left.
inline constexpr double outerHandleGapPx = 30.0;   ///< from ring to handles, device-independent
inline constexpr double outerHandleHalfRad = 0.5;   ///< half of the angle each handle spans, seen from the center

/// Current appearance of the handles; lengths in device px, y up.
struct PoseHandleLook {
    Eigen::Vector2d center = Eigen::Vector2d::Zero();
    double radius = 0.0;   ///< radius of the roll ring; 0 hides all handles
    double pixelScale = 1.0;
    PoseHandle hot = PoseHandle::None;   ///< under the mouse
    PoseHandle active = PoseHandle::None;   ///< being dragged
    double rollStartRad = 0.0;   ///< counterclockwise from the right
    double rollSweepRad = 0.0;
    double slidePx = 0.0;   ///< drag of the active outer handle: to the right, or up
};

/// Draws cross, ring, arcs and slider for moving the pose on the image.
StrokeMesh poseHandleStrokes(const PoseHandleLook& look);

}   // namespace angiopose::ui