#pragma once

#include "core/registration/problem/registration_problem.h"
#include "core/registration/problem/wire_path.h"

#include <functional>

namespace angiopose::core {

/// Result of findWirePath.
struct WireResult {
    std::vector<WirePath>
        paths;   ///< the selected path, then the others by probability; empty if the wire follows no path
    Matrix6d covariance = Matrix6d::Zero();   ///< covariance of the first path's pose (see PoseUncertainty), including
                                              ///< the uncertainty of the path
    Vector6d initialStd = Vector6d::Zero();   ///< 1-σ of the initial pose (rad, mm)
    std::vector<std::uint8_t> isFollowed;   ///< one per tree point of the problem: 1 if it lies on the first path
    bool hasRequestedPath = true;   ///< false if the requested rank exceeds the number of paths
    double gapFraction = 0.0;   ///< fraction of the wire's length that bridges gaps between curves
};

/// Receives the completed fraction and the best pose so far after every path tested.
using WireObserver = std::function<ObserverDecision(double progress, const RigidTransform& best)>;

/// Finds the path of a single guidewire or catheter through the tree, and the corresponding pose (ALGORITHMS §6.22).
/// The initial pose is the previous registered pose, with the errors given in the options.
WireResult findWirePath(const RegistrationProblem& problem, const RegistrationOptions& options,
                        const WireObserver& observe);

}   // namespace angiopose::core
