#pragma once

#include "core/support/random.h"

#include <Eigen/Core>
#include <vector>

namespace angiopose::core {

/// Start and end of a vessel, and its course in between.
struct PathPlan {
    Eigen::Vector3d start;
    Eigen::Vector3d end;   ///< reached except for the waves
    Eigen::Vector3d startDirection;   ///< unit vector
    Eigen::Vector3d endDirection;   ///< unit vector
    double tortuosity = 1.0;   ///< 0: a plain curve; 1: waves of about 2 mm over 40 mm
};

/// Returns a smooth curve (mm) along the plan with lateral waves; points about 1 mm apart.
std::vector<Eigen::Vector3d> smoothPath(const PathPlan& plan, CounterRandom& random);

}   // namespace angiopose::core