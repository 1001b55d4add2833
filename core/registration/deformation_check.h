#pragma once

#include "core/registration/deformable/deform_vessels.h"
#include "core/registration/matching/target_lines.h"
#include "core/registration/problem/registration_problem.h"

#include <span>

namespace angiopose::core {

/// Rigid pose and the image in which it was found.
struct RigidFit {
    const RegistrationProblem& problem;
    const TargetLines& target;
    const RigidTransform& cameraFromPatient;
};

/// Quick test whether a fit looks as if the vessels were deformed (ALGORITHMS §11.5); decides whether to run the
/// deformable model. A rigid tree rarely triggers it.
bool looksDeformed(const RigidFit& fit);

/// Whether deformed vessels displace the rigid overlay so much that it is not reliable.
bool putsOverlayOff(const DeformableResult& deformed);

/// Whether a message lowers the confidence regardless of deformation.
bool speaksAgainstTrust(const Message& said);

/// Assessment of a rigid pose, to be corrected by the deformable registration.
struct RigidJudgement {
    PoseUncertainty& uncertainty;
    bool& trustworthy;
    Messages& warnings;
};

/// Deformable options with the initial pose errors taken from the registration options.
DeformableOptions deformationOptions(const RegistrationOptions& options);

/// Deforms the vessels from the rigid poses and updates the rigid result: the covariance includes the error of the
/// pose, the confidence drops if the overlay is off, and the messages state which part is off, by how much and how
/// certainly. If stopped early, marks the result as unreliable. Returns null if the vessels cannot be deformed (points
/// without curves). `observe`: see deformVessels.
std::shared_ptr<const DeformableResult> judgeByDeformation(std::span<const DeformableView> views,
                                                           const DeformableOptions& options, RigidJudgement judgement,
                                                           const IterationObserver& observe);

}   // namespace angiopose::core
