#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>

namespace angiopose::core {

/// What users are told about a tree that was traced.
std::string loopWarning(int loops);
std::string unitWarning();   ///< the values may be no Hounsfield units
std::string dimWarning(int parts);   ///< left out
std::string besideWarning(double besideMm);   ///< how far another great vessel runs beside the traced one
std::string startWarning(const std::optional<Eigen::Vector3d>& foundStart);   ///< where it began without a seed

}   // namespace angiopose::core