#include "core/registration/picture/vessel_brightness.h"

#include "core/imaging/image_filters.h"
#include "core/registration/picture/vessel_image.h"

#include <algorithm>
#include <cmath>

namespace angiopose::core {
namespace {

constexpr std::size_t levelCount = 5;
constexpr double finestPx = 1.0;
constexpr double coarsestPx = 16.0;
constexpr double narrowestMm = 0.1;
constexpr double unknownBrightRadiusMm = 1.0;
constexpr std::size_t manyPoints = 300;
constexpr std::size_t sparseStride = 3;

}   // namespace

VesselBrightness::VesselBrightness(const RegistrationProblem& problem) : camera_(problem.camera)
{
    const TreeSamples& tree = problem.tree;
    const std::size_t stride = tree.size() >= sparseStride * manyPoints ? sparseStride : 1;
    for (std::size_t i = 0; i < tree.size(); i += stride) {
        const double radiusMm =
            tree.radiusMm[i] > 0.0 ? std::max(tree.radiusMm[i], narrowestMm) : unknownBrightRadiusMm;
        points_.push_back(
            {tree.points[i] - tree.centroid, tree.tangents[i], radiusMm, 2.0 / (1.0 + std::exp(-2.0 * radiusMm))});
        weightSum_ += points_.back().weight;
    }
    const ImageF picture = vesselImage(problem);
    ImageF center = gaussianBlur(picture, finestPx);
    for (std::size_t level = 0; level < levelCount; ++level) {
        ImageF around = gaussianBlur(picture, finestPx * std::exp2(static_cast<double>(level) + 1.0));
        std::transform(center.pixels.begin(), center.pixels.end(), around.pixels.begin(), center.pixels.begin(),
                       [](float inner, float outer) { return inner - outer; });
        levels_.push_back(std::move(center));
        center = std::move(around);
    }
}

VesselBrightness::Level VesselBrightness::levelOf(const Eigen::Vector3d& pointInCamera, double radiusMm) const
{
    const double widthPx = radiusMm / millimetersPerPixel(camera_, pointInCamera.z());
    const double exponent = std::log(widthPx / finestPx) / std::log(coarsestPx / finestPx);
    const double place = std::clamp(exponent, 0.0, 1.0) * (levelCount - 1);
    const auto finer = std::min(static_cast<std::size_t>(place), levelCount - 2);
    return {finer, place - static_cast<double>(finer)};
}

double VesselBrightness::brightnessAt(const Eigen::Vector2d& pixel, const Level& level) const
{
    if (!isInside(levels_.front(), pixel)) {
        return 0.0;
    }
    const double finer = sampleBilinear(levels_[level.finer], pixel.x(), pixel.y());
    const double coarser = sampleBilinear(levels_[level.finer + 1], pixel.x(), pixel.y());
    return finer + level.share * (coarser - finer);
}

Eigen::Vector2d VesselBrightness::gradientAt(const Eigen::Vector2d& pixel, const Level& level) const
{
    const Eigen::Vector2d finer = core::gradientAt(levels_[level.finer], pixel);
    const Eigen::Vector2d coarser = core::gradientAt(levels_[level.finer + 1], pixel);
    return finer + level.share * (coarser - finer);
}

double VesselBrightness::meanAt(const CentroidPose& pose, double widthScale) const
{
    double sum = 0.0;
    for (const Point& point : points_) {
        const Eigen::Vector3d inCamera = pose.rotation * point.fromCentroid + pose.centroidInCamera;
        if (const auto pixel = project(camera_, inCamera)) {
            sum += point.weight * brightnessAt(*pixel, levelOf(inCamera, widthScale * point.radiusMm));
        }
    }
    return sum / weightSum_;
}

NormalEquations VesselBrightness::normalEquations(const CentroidPose& pose, double widthScale) const
{
    NormalEquations equations;
    for (const Point& point : points_) {
        const Eigen::Vector3d arm = pose.rotation * point.fromCentroid;
        const Eigen::Vector3d inCamera = arm + pose.centroidInCamera;
        const auto pixel = project(camera_, inCamera);
        if (!pixel) {
            continue;
        }
        const auto jacobian = projectionJacobian(camera_, inCamera);
        const Eigen::Vector2d along = jacobian * (pose.rotation * point.tangent);
        const Eigen::Vector2d across = Eigen::Vector2d(-along.y(), along.x()).normalized();
        if (!across.allFinite()) {
            continue;   // vessel seen end-on
        }
        const double slope = across.dot(gradientAt(*pixel, levelOf(inCamera, widthScale * point.radiusMm)));
        const Eigen::Vector3d row = jacobian.transpose() * across;
        Vector6d gradient;
        gradient << arm.cross(row), row;
        const double weight = point.weight / weightSum_;
        equations.hessian += weight * gradient * gradient.transpose();
        equations.gradient -= 0.5 * weight * slope * gradient;
    }
    return equations;
}

}   // namespace angiopose::core
