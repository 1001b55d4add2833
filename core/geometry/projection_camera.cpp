#include "core/geometry/projection_camera.h"

#include "core/messages/messages.h"

#include <cmath>

namespace angiopose::core {

std::optional<Eigen::Vector2d> project(const ProjectionCamera& camera, const Eigen::Vector3d& pointInCamera)
{
    const double depth = pointInCamera.z();
    if (!(depth >= minProjectableDepthMm)) {
        return std::nullopt;
    }
    return Eigen::Vector2d(camera.fx * pointInCamera.x() / depth + camera.cx,
                           camera.fy * pointInCamera.y() / depth + camera.cy);
}

Eigen::Matrix<double, 2, 3> projectionJacobian(const ProjectionCamera& camera, const Eigen::Vector3d& pointInCamera)
{
    const double inverseDepth = 1.0 / pointInCamera.z();
    const double a = camera.fx * inverseDepth;
    const double b = camera.fy * inverseDepth;
    Eigen::Matrix<double, 2, 3> jacobian;
    jacobian << a, 0.0, -a * pointInCamera.x() * inverseDepth, 0.0, b, -b * pointInCamera.y() * inverseDepth;
    return jacobian;
}

Eigen::Vector3d rayThroughPixel(const ProjectionCamera& camera, const Eigen::Vector2d& pixel)
{
    return Eigen::Vector3d((pixel.x() - camera.cx) / camera.fx, (pixel.y() - camera.cy) / camera.fy, 1.0).normalized();
}

double millimetersPerPixel(const ProjectionCamera& camera, double depthMm)
{
    return depthMm / std::abs(camera.fx);
}

std::optional<Message> findProblem(const ProjectionCamera& camera)
{
    if (!std::isfinite(camera.fx) || !std::isfinite(camera.fy) || camera.fx == 0.0 || camera.fy == 0.0) {
        return messages::cameraFocalLengths();
    }
    if (!std::isfinite(camera.cx) || !std::isfinite(camera.cy)) {
        return messages::cameraPrincipalPoint();
    }
    if (camera.width <= 0 || camera.height <= 0) {
        return messages::cameraImageSize();
    }
    return {};
}

}   // namespace angiopose::core
