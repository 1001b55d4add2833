#pragma once

#include "ui/scenes/stroke_mesh.h"

namespace angiopose::ui {

enum class PoseHandle { None, Shift, Roll, LaoRao, CraCau, Depth };

/// Layout of the handles around the roll ring: LAO/RAO below, CRA/CAU to the right, depth to the left.
inline constexpr double outerHandleGapPx = 30.0;   ///< gap between ring and handles, logical px
inline constexpr double outerHandleHalfRad = 0.5;   ///< half the angle that a handle spans, as seen from the center

/// State of the handles to draw; lengths in device px, y up.
struct PoseHandleState {
    Eigen::Vector2d center = Eigen::Vector2d::Zero();
    double radius = 0.0;   ///< radius of the roll ring; all handles are hidden if 0
    double pixelScale = 1.0;
    PoseHandle hovered = PoseHandle::None;   ///< handle under the pointer
    PoseHandle active = PoseHandle::None;   ///< handle being dragged
    double rollStartRad = 0.0;   ///< start angle of the roll, counterclockwise from the +x axis
    double rollSweepRad = 0.0;
    double slidePx = 0.0;   ///< drag distance of the active outer handle, positive to the right or up
};

/// Returns the cross, ring, arcs and slider with which the user moves the pose on the image.
StrokeMesh poseHandleStrokes(const PoseHandleState& state);

}   // namespace angiopose::ui
