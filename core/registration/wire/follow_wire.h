#pragma once

#include "core/registration/problem/registration_problem.h"
#include "core/registration/problem/wire_path.h"

#include <functional>

namespace angiopose::core {

/// Result of following a wire.
struct WireFinding {
    std::vector<WirePath>
        paths;   ///< the selected path first, then the others, most likely first; empty if none can be followed
    Matrix6d covariance = Matrix6d::Zero();   ///< covariance of the first path's pose (see PoseUncertainty), including
                                              ///< the uncertainty of the path
    Vector6d stdBefore = Vector6d::Zero();   ///< 1-σ of the initial pose (rad, mm)
    std::vector<std::uint8_t> isFollowed;   ///< 1 for each tree point of the problem on the first path
    bool isAskedFor = true;   ///< false: fewer paths exist than the requested rank
    double gapShare = 0.0;   ///< share of the line bridged between curves
};

/// Called for every path tested, with the completed share of the work and the best pose so far.
using WireObserver = std::function<Verdict(double progress, const RigidTransform& best)>;

/// Finds the path of a single wire or catheter through the tree and the corresponding pose of the tree (ALGORITHMS
/// §6.22). The initial pose is the last full one, with the errors given in the options.
WireFinding followWire(const RegistrationProblem& problem, const RegistrationOptions& options,
                       const WireObserver& observe);

}   // namespace angiopose::core
