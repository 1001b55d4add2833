#include "core/registration/pose/sqpnp.h"

#include <cassert>
#include <opencv2/calib3d.hpp>

namespace angiopose::core {

std::optional<RigidTransform> solveSqpnp(std::span<const Eigen::Vector3d> points,
                                         std::span<const Eigen::Vector2d> pixels, const ProjectionCamera& camera)
{
    assert(points.size() == pixels.size());
    std::vector<cv::Point3d> objectPoints;
    std::vector<cv::Point2d> imagePoints;
    for (std::size_t i = 0; i < points.size(); ++i) {
        objectPoints.emplace_back(points[i].x(), points[i].y(), points[i].z());
        // Normalized coordinates undo the mirroring of an image (fx < 0).
        imagePoints.emplace_back((pixels[i].x() - camera.cx) / camera.fx, (pixels[i].y() - camera.cy) / camera.fy);
    }
    if (points.size() < 3) {
        return std::nullopt;
    }
    cv::Vec3d turn;
    cv::Vec3d shift;
    try {
        if (!cv::solvePnP(objectPoints, imagePoints, cv::Matx33d::eye(), cv::noArray(), turn, shift, false,
                          cv::SOLVEPNP_SQPNP)) {
            return std::nullopt;
        }
    } catch (const cv::Exception&) {
        return std::nullopt;   // degenerate pairs
    }
    const RigidTransform pose{expSo3(Eigen::Vector3d(turn[0], turn[1], turn[2])),
                              Eigen::Vector3d(shift[0], shift[1], shift[2])};
    return pose.matrix().allFinite() ? std::optional(pose) : std::nullopt;
}

}   // namespace angiopose::core
