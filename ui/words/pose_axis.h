#pragma once

#include "core/geometry/pose_axis.h"

#include <QString>
#include <Qt>

#include <optional>

namespace angiopose::ui {

using core::poseAxes;
using core::PoseAxis;
using core::PoseLocks;
using core::valueOf;

bool isShift(PoseAxis axis);   ///< mm; otherwise an angle in degrees
QString labelOf(PoseAxis axis);
QString explanationOf(PoseAxis axis);

/// `change` without its locked parts.
core::PoseOffset withoutLocked(core::PoseOffset change, const PoseLocks& locks);

/// a + b, part by part: right for changes of one degree of freedom, which is what keys and fields make.
core::PoseOffset sum(const core::PoseOffset& a, const core::PoseOffset& b);

/// One key press in nudge mode.
struct Nudge {
    PoseAxis axis;
    double amount;   ///< mm or degrees
};

/// What a key does in nudge mode: arrows 1 mm, PgUp/PgDn along the ray, `,` `.` roll, Alt+arrows angulation;
/// Shift ten times, Ctrl a tenth.
std::optional<Nudge> nudgeOfKey(int key, Qt::KeyboardModifiers modifiers);

}   // namespace angiopose::ui