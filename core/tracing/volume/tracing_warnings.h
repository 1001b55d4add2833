#pragma once

#include "core/support/message.h"
#include "core/tracing/tree/close_gaps.h"
#include "core/tracing/tree/skeleton_coverage.h"
#include "core/tracing/volume/chosen/adjacent_lumen.h"

#include <Eigen/Core>
#include <optional>

namespace angiopose::core {

/// Warnings for users about a traced tree.
Message loopWarning(int loops);
Message gapWarning(const ClosedGaps& gaps);
Message coverageWarning(const SkeletonCoverage& cover);
Message unitWarning();   ///< warns that the values may not be Hounsfield units
Message dimSubtreeWarning(int parts);   ///< `parts` is the number of excluded parts
Message adjacentLumenWarning(const AdjacentLumen& other);
/// Returns the position of the other lumen that one of these warnings reports; nullopt if none does.
std::optional<Eigen::Vector3d> adjacentLumenPosition(const Messages& warnings);
Message startWarning(const std::optional<Eigen::Vector3d>& foundStart);   ///< where tracing started without a seed

}   // namespace angiopose::core
