#pragma once

#include "ui/scenes/stroke_mesh.h"

namespace angiopose::ui {

enum class PoseHandle { None, Shift, Roll, LaoRao, CraCau, Depth };

/// Around the roll ring lie the turns, below it LAO/RAO and at its right CRA/CAU, and at its left the depth.
inline constexpr double outerHandleGapPx = 30.0;   ///< from ring to handles, device-independent
inline constexpr double outerHandleHalfRad = 0.5;   ///< half of what each spans, seen from the centre

/// What the handles look like at this moment; lengths in device px, y up.
struct PoseHandleLook {
    Eigen::Vector2d center = Eigen::Vector2d::Zero();
    double radius = 0.0;   ///< of the roll ring; 0 hides everything
    double pixelScale = 1.0;
    PoseHandle hot = PoseHandle::None;   ///< under the mouse
    PoseHandle active = PoseHandle::None;   ///< being dragged
    double rollStartRad = 0.0;   ///< counter-clockwise from the right
    double rollSweepRad = 0.0;
    double slidePx = 0.0;   ///< how far the active outer handle has been dragged: right, or up
};

/// Cross, ring, arcs and slide by which the pose is grasped on the image.
StrokeMesh poseHandleStrokes(const PoseHandleLook& look);

}   // namespace angiopose::ui