#pragma once

#include "core/registration/judging/distance_metrics.h"
#include "core/registration/matching/target_lines.h"

#include <cstddef>

namespace angiopose::core {

/// How the widths of the traced vessels go with those of the tree that lies on them.
struct ObservedDiameter {
    std::size_t pairs = 0;   ///< tree points on vessels, both widths known
    double ratio = 0.0;   ///< seen over expected; the median
    double correlation = 0.0;   ///< of the logarithms of both along the vessels; 0 where one of them does not change
};

/// `projected` is the tree at that pose. No pairs where tree or target have no widths.
ObservedDiameter observedDiameter(const RegistrationProblem& problem, const TargetLines& target,
                                  const RigidTransform& cameraFromPatient, const ProjectedTree& projected);

/// Whether these are vessels filled with contrast medium, not a wire or catheter that lies in them: about as wide as
/// they should be, and narrow and wide where the tree is, as no device is (ALGORITHMS §6.16).
bool isLumen(const ObservedDiameter& diameter);

}   // namespace angiopose::core
