#pragma once

#include "core/geometry/projection_camera.h"

#include <Eigen/Core>

namespace angiopose::benchmarks {

inline constexpr double sourceToDetectorMm = 1100.0;
inline constexpr double sourceToPatientMm = 720.0;
inline constexpr double pixelMm = 0.31;
inline constexpr int imagePx = 960;

/// Pinhole projection of a right-handed camera frame in mm to px, implemented independently because the project's
/// projection is under test.
Eigen::Vector2d pixelOf(const Eigen::Vector3d& inCamera);

core::ProjectionCamera detectorCamera();

bool isOnDetector(const Eigen::Vector2d& pixel);

}   // namespace angiopose::benchmarks
