#pragma once

#include "core/geometry/pose_offset.h"
#include "ui/scenes/pose_handles.h"

#include <Eigen/Core>

namespace angiopose::ui {

/// Geometry of the pose handles in widget px (y down).
struct NudgeGrip {
    Eigen::Vector2d center = Eigen::Vector2d::Zero();
    double ringRadius = 0.0;   ///< radius of the roll ring; if 0, there are no handles
    Eigen::Vector2d mmPerPx = Eigen::Vector2d::Zero();   ///< mm per widget px at the depth of the pivot, along u and v
};

/// Returns the handle at a widget position: the ring (with a wide margin) for roll, the arcs for tilting, the slider
/// for depth; elsewhere, a drag shifts the tree.
PoseHandle handleAt(const NudgeGrip& grip, const Eigen::Vector2d& position);

/// Current drag of the tree, accumulated step by step, since the pace can change during the drag.
class NudgeDrag {
public:
    NudgeDrag(PoseHandle handle, const NudgeGrip& grip, const Eigen::Vector2d& start);

    /// Moves the drag to `position` and returns its total offset; `pace` scales only this step (0.1 for fine steps).
    core::PoseOffset moveTo(const Eigen::Vector2d& position, double speedFactor);

    PoseHandle handle() const { return handle_; }
    const Eigen::Vector2d& center() const { return center_; }
    double startAngleRad() const { return startRad_; }   ///< angle on the screen, clockwise from the +x axis
    double sweepRad() const { return sweepRad_; }
    double slidePx() const;   ///< drag distance of an outer handle, positive to the right or up

private:
    PoseHandle handle_;
    Eigen::Vector2d center_;
    Eigen::Vector2d mmPerPx_;
    double degPerPx_;
    Eigen::Vector2d last_;
    Eigen::Vector2d shiftPx_ = Eigen::Vector2d::Zero();
    double startRad_ = 0.0;
    double sweepRad_ = 0.0;
};

/// Returns the angle on the screen (y down) of a position around a center, clockwise from the +x axis.
double screenAngleRad(const Eigen::Vector2d& center, const Eigen::Vector2d& position);

}   // namespace angiopose::ui
