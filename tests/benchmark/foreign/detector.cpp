#include "tests/benchmark/foreign/detector.h"

namespace angiopose::benchmarks {

Eigen::Vector2d pixelOf(const Eigen::Vector3d& inCamera)
{
    const double magnified = sourceToDetectorMm / inCamera.z() / pixelMm;
    const double middle = 0.5 * (imagePx - 1);
    return {middle - magnified * inCamera.x(), middle + magnified * inCamera.y()};
}

core::ProjectionCamera detectorCamera()
{
    const double focalPx = sourceToDetectorMm / pixelMm;
    const double middle = 0.5 * (imagePx - 1);
    return {-focalPx, focalPx, middle, middle, imagePx, imagePx};
}

bool isOnDetector(const Eigen::Vector2d& pixel)
{
    return pixel.minCoeff() >= -0.5 && pixel.maxCoeff() < imagePx - 0.5;
}

}   // namespace angiopose::benchmarks
