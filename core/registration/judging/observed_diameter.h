#pragma once

#include "core/registration/judging/distance_metrics.h"
#include "core/registration/matching/target_lines.h"

#include <cstddef>

namespace angiopose::core {

/// Comparison of the traced vessel widths with the widths of the projected tree.
struct ObservedDiameter {
    std::size_t pairs = 0;   ///< number of tree points that lie on a vessel and have both widths
    double ratio = 0.0;   ///< median of observed over expected width
    double correlation = 0.0;   ///< correlation of the log widths along the vessels; 0 if either is constant
};

/// Compares the widths at a pose whose projection is `projected`; returns no pairs if tree or target lacks widths.
ObservedDiameter observedDiameter(const RegistrationProblem& problem, const TargetLines& target,
                                  const RigidTransform& cameraFromPatient, const ProjectedTree& projected);

/// Whether the traced curves are opacified vessels rather than a guidewire or catheter: about as wide as expected and,
/// unlike a device, varying in width along with the tree (ALGORITHMS §6.16).
bool isLumen(const ObservedDiameter& diameter);

}   // namespace angiopose::core
