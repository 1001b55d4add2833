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

/// Returns `change` with its locked components set to zero.
core::PoseOffset withoutLocked(core::PoseOffset change, const PoseLocks& locks);

/// Adds component by component: exact for changes of one degree of freedom, as made by keys and fields.
core::PoseOffset sum(const core::PoseOffset& a, const core::PoseOffset& b);

/// Effect of one key press in nudge mode.
struct Nudge {
    PoseAxis axis;
    double amount;   ///< mm or degrees
};

/// Maps a key to its nudge: arrows 1 mm, PgUp/PgDn depth, `,` `.` roll, Alt+arrows angulation; ×10 with Shift, ×0.1
/// with Ctrl.
std::optional<Nudge> nudgeOfKey(int key, Qt::KeyboardModifiers modifiers);

}   // namespace angiopose::ui