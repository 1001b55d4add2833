#pragma once

#include "core/support/message.h"
#include "core/tracing/tree/close_gaps.h"
#include "core/tracing/tree/skeleton_cover.h"
#include "core/tracing/volume/chosen/other_lumen.h"

#include <Eigen/Core>
#include <optional>

namespace angiopose::core {

/// What users are told about a tree that was traced.
Message loopWarning(int loops);
Message gapWarning(const ClosedGaps& gaps);
Message coverWarning(const SkeletonCover& cover);
Message unitWarning();   ///< the values may be no Hounsfield units
Message dimWarning(int parts);   ///< left out
Message besideWarning(const OtherLumen& other);
/// Where the other lumen is that one of these is about; none of them: nothing.
std::optional<Eigen::Vector3d> otherLumenOf(const Messages& warnings);
Message startWarning(const std::optional<Eigen::Vector3d>& foundStart);   ///< where it began without a seed

}   // namespace angiopose::core