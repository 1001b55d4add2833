#pragma once

#include "core/geometry/rigid_transform.h"

#include <optional>
#include <span>

namespace angiopose::core {

/// Where the vessels were at a moment of a run.
struct TimedPose {
    double seconds = 0.0;
    RigidTransform cameraFromPatient;
};

/// A motion that comes again and again.
struct PeriodicMotion {
    double periodS = 0.0;
    double amplitudeMm = 0.0;   ///< half the way to and fro, across the rays
    double share = 0.0;   ///< of the squared motion that it explains, 0…1
};

/// The periods of a run; nothing where the run is too short to show two of them, or shows none.
struct RunPeriods {
    std::optional<PeriodicMotion> breath;   ///< of 2 to 10 s
    std::optional<PeriodicMotion> heart;   ///< of 0.4 to 1.5 s
};

/// Finds breath and heart in how a point of the vessels moved across the rays (ALGORITHMS §6.11): least-squares spectra
/// of what is left when a drift is taken away, so that frames may be missing (Lomb 1976). A period counts where the
/// chance that noise shows so high a peak is below 1 in 10,000 (Fisher 1929).
RunPeriods findPeriods(std::span<const TimedPose> poses, const Eigen::Vector3d& pointInPatient);

}   // namespace angiopose::core
