#pragma once

#include "core/geometry/pose_offset.h"

#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace angiopose::core {

/// The six degrees of freedom of a PoseOffset, in the order of the pose panel.
enum class PoseAxis { Right, Up, AlongRay, Roll, LaoRao, CraCau };

inline constexpr std::array poseAxes{PoseAxis::Right, PoseAxis::Up,     PoseAxis::AlongRay,
                                     PoseAxis::Roll,  PoseAxis::LaoRao, PoseAxis::CraCau};

/// Whether each degree of freedom is locked at its current value; indexed by PoseAxis.
using PoseLocks = std::array<bool, poseAxes.size()>;

inline bool isLocked(const PoseLocks& locks, PoseAxis axis)
{
    return locks[static_cast<std::size_t>(axis)];
}
bool isAnyLocked(const PoseLocks& locks);

double& valueOf(PoseOffset& offset, PoseAxis axis);
double valueOf(const PoseOffset& offset, PoseAxis axis);

/// Returns the id used in files and on the command line: "right", "up", "along-ray", "roll", "lao-rao", "cra-cau".
std::string_view idOf(PoseAxis axis);
std::optional<PoseAxis> parsePoseAxis(std::string_view id);

/// Returns all ids in order, separated by commas, for messages.
std::string poseAxisIds();

}   // namespace angiopose::core
