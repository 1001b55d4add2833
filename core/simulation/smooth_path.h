#pragma once

#include "core/support/random.h"

#include <Eigen/Core>
#include <vector>

namespace angiopose::core {

/// Start and end of a vessel, with the directions there.
struct PathPlan {
    Eigen::Vector3d start;
    Eigen::Vector3d end;   ///< end point, apart from the displacement by the waves
    Eigen::Vector3d startDirection;   ///< unit vector
    Eigen::Vector3d endDirection;   ///< unit vector
    double tortuosity = 1.0;   ///< 0 for a plain curve, 1 for waves of about 2 mm over 40 mm
};

/// Returns a smooth curve in mm that follows the plan with lateral waves; the points are about 1 mm apart.
std::vector<Eigen::Vector3d> smoothPath(const PathPlan& plan, CounterRandom& random);

}   // namespace angiopose::core
