#pragma once

#include "core/geometry/pose_offset.h"
#include "ui/scenes/pose_handles.h"

#include <Eigen/Core>

namespace angiopose::ui {

/// Position of the pose handles, in widget px (v down).
struct NudgeGrip {
    Eigen::Vector2d center = Eigen::Vector2d::Zero();
    double ringRadius = 0.0;   ///< 0: no handles
    Eigen::Vector2d mmPerPx = Eigen::Vector2d::Zero();   ///< mm per widget px at the pivot's depth, along u and v
};

/// Returns the handle at a widget position: the ring (with a generous margin) rolls, arcs tilt, the slider changes
/// depth, everything else shifts.
PoseHandle handleAt(const NudgeGrip& grip, const Eigen::Vector2d& position);

/// One drag of the tree, accumulated step by step because its speed may change meanwhile.
class NudgeDrag {
public:
    NudgeDrag(PoseHandle handle, const NudgeGrip& grip, const Eigen::Vector2d& start);

    /// Returns the total offset of the drag; `pace` scales this step (0.1 is fine).
    core::PoseOffset moveTo(const Eigen::Vector2d& position, double pace);

    PoseHandle handle() const { return handle_; }
    const Eigen::Vector2d& center() const { return center_; }
    double startAngleRad() const { return startRad_; }   ///< clockwise on screen from the right
    double sweepRad() const { return sweepRad_; }
    double slidePx() const;   ///< of an outer handle: to the right, or up

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

/// Returns the clockwise angle on screen (v down) of a position around a center.
double screenAngleRad(const Eigen::Vector2d& center, const Eigen::Vector2d& position);

}   // namespace angiopose::ui