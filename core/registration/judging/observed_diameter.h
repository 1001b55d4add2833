#pragma once

#include "core/registration/judging/distance_metrics.h"
#include "core/registration/matching/target_lines.h"

#include <cstddef>

namespace angiopose::core {

/// Relation between the widths of the traced vessels and those of the tree projected onto them.
struct ObservedDiameter {
    std::size_t pairs = 0;   ///< tree points on vessels with both widths known
    double ratio = 0.0;   ///< median of observed over expected width
    double correlation = 0.0;   ///< of the log widths along the vessels; 0 if one of them is constant
};

/// `projected` is the tree at that pose. Contains no pairs if tree or target has no widths.
ObservedDiameter observedDiameter(const RegistrationProblem& problem, const TargetLines& target,
                                  const RigidTransform& cameraFromPatient, const ProjectedTree& projected);

/// Whether these are opacified vessels instead of a wire or catheter inside them: roughly as wide as expected, and wide
/// and narrow where the tree is, unlike any device (ALGORITHMS §6.16).
bool isLumen(const ObservedDiameter& diameter);

}   // namespace angiopose::core
