#include "core/registration/picture/tube_image.h"

#include <algorithm>
#include <cmath>

namespace angiopose::core {
namespace {

constexpr double unknownRadiusPx = 1.5;
constexpr double unknownPictureRadiusMm = 1.0;
constexpr double softEdgePx = 0.5;   // half the extent of one pixel, added to the radius
constexpr double maxSegmentPx = 40.0;   // longer segments would join unrelated points

double distanceToPiece(const Eigen::Vector2d& point, const Eigen::Vector2d& from, const Eigen::Vector2d& along,
                       double squaredLength)
{
    const double share = squaredLength > 0.0 ? std::clamp((point - from).dot(along) / squaredLength, 0.0, 1.0) : 0.0;
    return (point - from - share * along).norm();
}

}   // namespace

void drawTube(ImageF& image, const Eigen::Vector2d& fromPx, const Eigen::Vector2d& toPx, double radiusPx)
{
    const double reach = radiusPx + softEdgePx;
    const Eigen::Vector2d low = fromPx.cwiseMin(toPx).array() - reach;
    const Eigen::Vector2d high = fromPx.cwiseMax(toPx).array() + reach;
    const bool isNear = high.x() >= 0.0 && high.y() >= 0.0 && low.x() <= image.width - 1 && low.y() <= image.height - 1;
    if (!isNear || (toPx - fromPx).squaredNorm() > maxSegmentPx * maxSegmentPx) {
        return;
    }
    const Eigen::Vector2d along = toPx - fromPx;
    const double squaredLength = along.squaredNorm();
    const int left = std::max(0, static_cast<int>(std::ceil(low.x())));
    const int right = std::min(image.width - 1, static_cast<int>(high.x()));
    const int top = std::max(0, static_cast<int>(std::ceil(low.y())));
    const int bottom = std::min(image.height - 1, static_cast<int>(high.y()));
    for (int y = top; y <= bottom; ++y) {
        for (int x = left; x <= right; ++x) {
            const double distance = distanceToPiece(Eigen::Vector2d(x, y), fromPx, along, squaredLength);
            const double squares = reach * reach - distance * distance;
            if (squares > 0.0) {
                image.at(x, y) = std::max(image.at(x, y), static_cast<float>(2.0 * std::sqrt(squares)));
            }
        }
    }
}

ImageF renderTubes(const TargetSamples& target, int width, int height)
{
    ImageF image(width, height);
    for (std::size_t i = 0; i < target.size(); ++i) {
        const bool follows = i > 0 && target.curveIndex[i] == target.curveIndex[i - 1];
        const double radiusPx = target.radiusPx[i] > 0.0 ? target.radiusPx[i] : unknownRadiusPx;
        drawTube(image, target.points[follows ? i - 1 : i], target.points[i], radiusPx);
    }
    return image;
}

ImageF renderTubes(const TreeSamples& tree, const ProjectionCamera& camera, const RigidTransform& cameraFromPatient)
{
    ImageF image(camera.width, camera.height);
    std::optional<Eigen::Vector2d> before;
    for (std::size_t i = 0; i < tree.size(); ++i) {
        if (i > 0 && tree.branchIndex[i] != tree.branchIndex[i - 1]) {
            before.reset();
        }
        const Eigen::Vector3d point = cameraFromPatient * tree.points[i];
        const std::optional<Eigen::Vector2d> pixel = project(camera, point);
        if (pixel) {
            const double radiusMm = tree.radiusMm[i] > 0.0 ? tree.radiusMm[i] : unknownPictureRadiusMm;
            drawTube(image, before.value_or(*pixel), *pixel, radiusMm / millimetersPerPixel(camera, point.z()));
        }
        before = pixel;
    }
    return image;
}

ProjectionCamera halfSizeCamera(const ProjectionCamera& camera)
{
    ProjectionCamera half = camera;
    half.fx = 0.5 * camera.fx;
    half.fy = 0.5 * camera.fy;
    half.cx = 0.5 * (camera.cx - 0.5);
    half.cy = 0.5 * (camera.cy - 0.5);
    half.width = (camera.width + 1) / 2;
    half.height = (camera.height + 1) / 2;
    return half;
}

}   // namespace angiopose::core
