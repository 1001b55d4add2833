#pragma once

#include <Eigen/Core>
#include <vector>

namespace angiopose::core {

/// Penalized least squares, min Σ wᵢ|xᵢ − yᵢ|² + λ Σ |second difference of x|²: the smoothing spline on evenly spaced
/// points (Whittaker 1923; Eilers 2003). One weight per point in `weights`; straight lines stay unchanged.
std::vector<Eigen::Vector2d> smoothSpline(const std::vector<Eigen::Vector2d>& points,
                                          const std::vector<double>& weights, double lambda);
std::vector<Eigen::Vector3d> smoothSpline(const std::vector<Eigen::Vector3d>& points,
                                          const std::vector<double>& weights, double lambda);
std::vector<double> smoothSpline(const std::vector<double>& values, const std::vector<double>& weights, double lambda);

}   // namespace angiopose::core
