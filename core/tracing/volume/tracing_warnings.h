#pragma once

#include "core/support/message.h"
#include "core/tracing/tree/close_gaps.h"
#include "core/tracing/tree/skeleton_cover.h"
#include "core/tracing/volume/chosen/other_lumen.h"

#include <Eigen/Core>
#include <optional>

namespace angiopose::core {

/// Warnings for users about a traced tree.
Message loopWarning(int loops);
Message gapWarning(const ClosedGaps& gaps);
Message coverWarning(const SkeletonCover& cover);
Message unitWarning();   ///< warns that the values may not be Hounsfield units
Message dimWarning(int parts);   ///< `parts`: number of excluded parts
Message besideWarning(const OtherLumen& other);
/// Position of the other lumen that one of these warnings reports; nothing if none does.
std::optional<Eigen::Vector3d> otherLumenOf(const Messages& warnings);
Message startWarning(const std::optional<Eigen::Vector3d>& foundStart);   ///< where tracing started without a seed

}   // namespace angiopose::core
