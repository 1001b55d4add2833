#pragma once

#include "core/registration/deformable/deform_vessels.h"
#include "core/registration/matching/target_lines.h"
#include "core/registration/problem/registration_problem.h"

#include <span>

namespace angiopose::core {

/// Rigid pose together with the problem and the target lines to which it was registered.
struct RigidFit {
    const RegistrationProblem& problem;
    const TargetLines& target;
    const RigidTransform& cameraFromPatient;
};

/// Whether the vessels appear deformed relative to a rigid fit (ALGORITHMS §11.5). This quick test decides whether to
/// run the deformable registration; it is rarely true for a rigid tree.
bool looksDeformed(const RigidFit& fit);

/// Whether the deformation displaces the vessels so far that the rigid overlay is unreliable.
bool makesOverlayUnreliable(const DeformableResult& deformed);

/// Whether a message lowers the confidence regardless of the deformation.
bool lowersConfidence(const Message& said);

/// Assessment of a rigid pose, to be updated by the deformable registration.
struct RigidAssessment {
    PoseUncertainty& uncertainty;
    bool& trustworthy;
    Messages& warnings;
};

/// Returns deformable options whose initial pose errors are those of the registration options.
DeformableOptions deformationOptions(const RegistrationOptions& options);

/// Deforms the vessels from the rigid poses and updates the assessment: the covariance includes the error of the rigid
/// pose, the confidence drops if the overlay is too far off, and messages state which part is displaced, by how much
/// and how certainly. If stopped early, marks the result as unreliable. Returns null if the vessels cannot be deformed
/// (target points without curves). For `observe`, see deformVessels.
std::shared_ptr<const DeformableResult> deformAndAssess(std::span<const DeformableView> views,
                                                        const DeformableOptions& options, RigidAssessment assessment,
                                                        const IterationObserver& observe);

}   // namespace angiopose::core
