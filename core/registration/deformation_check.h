#pragma once

#include "core/registration/deformable/deform_vessels.h"
#include "core/registration/matching/target_lines.h"
#include "core/registration/problem/registration_problem.h"

#include <span>

namespace angiopose::core {

/// A rigid pose and the image it was found in.
struct RigidFit {
    const RegistrationProblem& problem;
    const TargetLines& target;
    const RigidTransform& cameraFromPatient;
};

/// Whether a fit looks as if the vessels were bent (ALGORITHMS §11.5): decides, cheaply, whether the bent model is
/// asked. A rigid tree seldom looks so.
bool looksDeformed(const RigidFit& fit);

/// Whether bent vessels put the rigid overlay so far off that it is not to be trusted.
bool putsOverlayOff(const DeformableResult& deformed);

/// Whether a sentence speaks against trust, whatever the vessels do.
bool speaksAgainstTrust(const Message& said);

/// What is said of a rigid pose, to be corrected by what bending found.
struct RigidJudgement {
    PoseUncertainty& uncertainty;
    bool& trustworthy;
    Messages& warnings;
};

/// The start pose's errors as the options have them.
DeformableOptions deformationOptions(const RegistrationOptions& options);

/// Bends the vessels from rigid poses and lets the rigid result say what that found: the covariance holds how far the
/// pose is off, trust falls where the overlay is, and the words tell which part lies how far off, and how surely.
/// Stopped before its end it leaves the result untrusted. Null where the vessels cannot be bent (points without
/// curves). `observe`: see deformVessels.
std::shared_ptr<const DeformableResult> judgeByDeformation(std::span<const DeformableView> views,
                                                           const DeformableOptions& options, RigidJudgement judgement,
                                                           const IterationObserver& observe);

}   // namespace angiopose::core
