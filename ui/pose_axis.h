#pragma once

#include "core/geometry/pose_offset.h"

#include <QString>
#include <Qt>

#include <array>
#include <optional>

namespace ui {

/// The six degrees of freedom as the user meets them, in the order of the pose panel.
enum class PoseAxis { Right, Up, AlongRay, Roll, LaoRao, CraCau };

inline constexpr std::array poseAxes{PoseAxis::Right, PoseAxis::Up,     PoseAxis::AlongRay,
                                     PoseAxis::Roll,  PoseAxis::LaoRao, PoseAxis::CraCau};

/// Degrees of freedom that editing by hand must not change, indexed by PoseAxis.
using PoseLocks = std::array<bool, poseAxes.size()>;

double& valueOf(core::PoseOffset& offset, PoseAxis axis);
double valueOf(const core::PoseOffset& offset, PoseAxis axis);
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

}   // namespace ui
