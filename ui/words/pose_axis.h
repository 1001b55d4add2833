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

bool isShift(PoseAxis axis);   ///< true for a shift in mm, false for an angle in degrees
QString labelOf(PoseAxis axis);
QString explanationOf(PoseAxis axis);

/// Returns `change` with its locked components set to zero.
core::PoseOffset zeroLocked(core::PoseOffset change, const PoseLocks& locks);

/// Adds two offsets component by component; exact if only one degree of freedom changes, as with keys and fields.
core::PoseOffset sum(const core::PoseOffset& a, const core::PoseOffset& b);

/// Pose change caused by one key press in nudge mode.
struct Nudge {
    PoseAxis axis;
    double amount;   ///< mm or degrees
};

/// Returns the nudge for a key: arrows shift by 1 mm, PgUp/PgDn change depth, `,` `.` roll, Alt+arrows change the
/// angulation; ×10 with Shift, ×0.1 with Ctrl.
std::optional<Nudge> nudgeOfKey(int key, Qt::KeyboardModifiers modifiers);

}   // namespace angiopose::ui
