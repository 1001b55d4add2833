#include "core/geometry/epipolar_line.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace angiopose::core {
namespace {

/// A ray in a camera frame: origin in mm, direction as unit vector.
struct CameraRay {
    Eigen::Vector3d origin;
    Eigen::Vector3d direction;
};

/// An interval on a ray, in mm from the origin of the ray.
struct RayInterval {
    double from = 0.0;
    double to = std::numeric_limits<double>::infinity();

    /// Restricts the interval to the distances s with `value + slope s >= 0`.
    void clipTo(double value, double slope)
    {
        if (slope > 0.0) {
            from = std::max(from, -value / slope);
        } else if (slope < 0.0) {
            to = std::min(to, -value / slope);
        } else if (!(value >= 0.0)) {
            to = -std::numeric_limits<double>::infinity();
        }
    }

    /// Restricts the interval to the half-space `normal · X >= offset`.
    void clipTo(const CameraRay& ray, const Eigen::Vector3d& normal, double offset)
    {
        clipTo(normal.dot(ray.origin) - offset, normal.dot(ray.direction));
    }
};

/// Returns the part of the ray visible to the camera: in front of the source, u ≥ −½ is `fx X + (cx + ½) Z ≥ 0`, etc.
RayInterval visibleInterval(const ProjectionCamera& camera, const CameraRay& ray)
{
    RayInterval seen;
    seen.clipTo(ray, Eigen::Vector3d::UnitZ(), minProjectableDepthMm);
    seen.clipTo(ray, {camera.fx, 0.0, camera.cx + 0.5}, 0.0);
    seen.clipTo(ray, {-camera.fx, 0.0, camera.width - 0.5 - camera.cx}, 0.0);
    seen.clipTo(ray, {0.0, camera.fy, camera.cy + 0.5}, 0.0);
    seen.clipTo(ray, {0.0, -camera.fy, camera.height - 0.5 - camera.cy}, 0.0);
    return seen;
}

/// Returns the pixel of the point at distance `mm` on the ray; the vanishing point for an infinite distance.
Eigen::Vector2d pixelAt(const ProjectionCamera& camera, const CameraRay& ray, double mm)
{
    const Eigen::Vector3d at = std::isfinite(mm) ? Eigen::Vector3d(ray.origin + mm * ray.direction) : ray.direction;
    return {camera.fx * at.x() / at.z() + camera.cx, camera.fy * at.y() / at.z() + camera.cy};
}

}   // namespace

std::optional<ImageSegment> epipolarLine(const PosedCamera& first, const Eigen::Vector2d& pixel,
                                         const PosedCamera& other)
{
    if (findProblem(first.camera) || findProblem(other.camera)) {
        return std::nullopt;
    }
    const Eigen::Vector3d throughPixel = rayThroughPixel(first.camera, pixel);
    const RigidTransform otherFromFirst = other.cameraFromPatient * first.cameraFromPatient.inverse();
    const CameraRay ray{otherFromFirst.translation, otherFromFirst.rotation * throughPixel};
    RayInterval seen = visibleInterval(other.camera, ray);
    seen.from = std::max(seen.from, minProjectableDepthMm / throughPixel.z());
    if (!(seen.from <= seen.to)) {
        return std::nullopt;
    }
    const ImageSegment segment{pixelAt(other.camera, ray, seen.from), pixelAt(other.camera, ray, seen.to)};
    return segment.beginPx.allFinite() && segment.endPx.allFinite() ? std::optional(segment) : std::nullopt;
}

}   // namespace angiopose::core
