#pragma once

#include "core/registration/problem/registration_problem.h"
#include "core/registration/problem/wire_path.h"

#include <functional>

namespace angiopose::core {

/// What is known of a wire.
struct WireFinding {
    std::vector<WirePath>
        paths;   ///< the one taken, then the others, most likely first; empty where none can be followed
    Matrix6d covariance =
        Matrix6d::Zero();   ///< of the first path's pose (see PoseUncertainty), in doubt of the path too
    Vector6d stdBefore = Vector6d::Zero();   ///< 1-σ of the start pose (rad, mm)
    std::vector<std::uint8_t> isFollowed;   ///< 1 for each tree point of the problem that lies on the first path
    bool isAskedFor = true;   ///< false: there are fewer ways than the options ask for
    double gapShare = 0.0;   ///< of the line, bridged between curves
};

/// Hears of every way tried: what share of the work is done, and the best pose so far.
using WireObserver = std::function<Verdict(double progress, const RigidTransform& best)>;

/// Finds which way of the tree a single wire or catheter takes, and how the tree lies then (ALGORITHMS §6.22). The
/// start is the last full pose, off by what the options say.
WireFinding followWire(const RegistrationProblem& problem, const RegistrationOptions& options,
                       const WireObserver& observe);

}   // namespace angiopose::core
