#pragma once

#include "core/support/random.h"

#include <Eigen/Core>
#include <vector>

namespace angiopose::core {

/// Where a vessel starts and ends, and how it winds in between.
struct PathPlan {
    Eigen::Vector3d start;
    Eigen::Vector3d end;   ///< reached but for the sway
    Eigen::Vector3d startDirection;   ///< unit
    Eigen::Vector3d endDirection;   ///< unit
    double tortuosity = 1.0;   ///< 0: a plain bend; 1: sways by about 2 mm over 40 mm
};

/// A smooth curve (mm) that leaves as planned, swaying to both sides; points about 1 mm apart.
std::vector<Eigen::Vector3d> smoothPath(const PathPlan& plan, CounterRandom& random);

}   // namespace angiopose::core