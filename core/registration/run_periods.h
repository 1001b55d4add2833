#pragma once

#include "core/geometry/rigid_transform.h"

#include <optional>
#include <span>

namespace angiopose::core {

/// Vessel pose at one time of a cine run.
struct TimedPose {
    double seconds = 0.0;
    RigidTransform cameraFromPatient;
};

/// Periodic component of the vessel motion.
struct PeriodicMotion {
    double periodS = 0.0;
    double amplitudeMm = 0.0;   ///< amplitude perpendicular to the projection rays
    double share = 0.0;   ///< explained fraction of the squared motion, 0…1
};

/// Periods of a cine run; each is nullopt if the run covers fewer than two periods or shows no such motion.
struct RunPeriods {
    std::optional<PeriodicMotion> breathMotion;   ///< breathing, period of 2 to 10 s
    std::optional<PeriodicMotion> heartMotion;   ///< heartbeat, period of 0.4 to 1.5 s
};

/// Detects breathing and heartbeat in the motion of a vessel point perpendicular to the projection rays (ALGORITHMS
/// §6.11), using least-squares spectra after detrending; frames may be missing (Lomb 1976). Accepts a period if noise
/// would produce a peak of this height with a probability below 1 in 10,000 (Fisher 1929).
RunPeriods findPeriods(std::span<const TimedPose> poses, const Eigen::Vector3d& pointInPatient);

}   // namespace angiopose::core
