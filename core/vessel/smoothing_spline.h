#pragma once

#include <Eigen/Core>
#include <vector>

namespace angiopose::core {

/// Returns the minimum of Σ wᵢ|xᵢ − yᵢ|² + λ Σ |second difference of x|²: the smoothing spline on evenly spaced points
/// (Whittaker 1923; Eilers 2003). `weights` holds one weight per point; straight lines stay unchanged.
std::vector<Eigen::Vector2d> smoothSpline(const std::vector<Eigen::Vector2d>& points,
                                          const std::vector<double>& weights, double lambda);
std::vector<Eigen::Vector3d> smoothSpline(const std::vector<Eigen::Vector3d>& points,
                                          const std::vector<double>& weights, double lambda);
std::vector<double> smoothSpline(const std::vector<double>& values, const std::vector<double>& weights, double lambda);

}   // namespace angiopose::core
