#include "core/registration/pnp/affine_icp.h"

#include <Eigen/Cholesky>
#include <cmath>
#include <limits>

namespace angiopose::core {
namespace {

constexpr double settledAffineShare = 1e-6;
constexpr int rigidIterations = 50;

/// Affine map x' = rows · (x, y, z, 1), z' = z, for which both image coordinates are linear in the rows.
struct AffineRows {
    Eigen::Vector4d x = Eigen::Vector4d::UnitX();
    Eigen::Vector4d y = Eigen::Vector4d::UnitY();
};

Eigen::Vector2d pixelOf(const ProjectionCamera& camera, const AffineRows& map, const Eigen::Vector3d& point)
{
    const Eigen::Vector4d homogeneous = point.homogeneous();
    return {camera.fx * map.x.dot(homogeneous) / point.z() + camera.cx,
            camera.fy * map.y.dot(homogeneous) / point.z() + camera.cy};
}

/// Sums of one iteration; both rows of the map share the weights but differ in focal length.
struct Round {
    Eigen::Matrix4d squares = Eigen::Matrix4d::Zero();
    Eigen::Vector4d towardsX = Eigen::Vector4d::Zero();
    Eigen::Vector4d towardsY = Eigen::Vector4d::Zero();
    double loss = 0.0;
};

Round accumulateRound(const KernelProblem& problem, const std::vector<Eigen::Vector3d>& points, const AffineRows& map,
                      double huberPx)
{
    Round round;
    for (const Eigen::Vector3d& point : points) {
        const Eigen::Vector2d pixel = pixelOf(problem.camera, map, point);
        const Eigen::Vector2d partner = problem.target->nearest(pixel);
        const double distancePx = (pixel - partner).norm();
        const double weight = distancePx <= huberPx ? 1.0 : huberPx / distancePx;
        const Eigen::Vector4d row = point.homogeneous() / point.z();
        round.squares += weight * row * row.transpose();
        round.towardsX += weight * (partner.x() - problem.camera.cx) / problem.camera.fx * row;
        round.towardsY += weight * (partner.y() - problem.camera.cy) / problem.camera.fy * row;
        round.loss += distancePx <= huberPx ? distancePx * distancePx : huberPx * (2.0 * distancePx - huberPx);
    }
    return round;
}

/// Returns the pose closest to the map in the image; with fixed matches, a wide kernel acts as plain least squares.
RigidTransform rigidPart(const KernelProblem& problem, const RigidTransform& start, const AffineRows& map)
{
    std::vector<Eigen::Vector3d> points;
    std::vector<Eigen::Vector2d> matchesPx;
    for (const Eigen::Vector3d& point : problem.points) {
        const Eigen::Vector3d inCamera = start * point;
        if (inCamera.z() > minProjectableDepthMm) {
            points.push_back(point);
            matchesPx.push_back(pixelOf(problem.camera, map, inCamera));
        }
    }
    KernelSchedule schedule;
    schedule.maxIterations = rigidIterations;
    schedule.finalScalePx = 1e3;
    KernelProblem known{points, problem.camera, problem.target, matchesPx};
    known.freedom = problem.freedom;
    return KernelPnp(known, {}, schedule).solve(start).pose;
}

}   // namespace

KernelPnpResult rigidPartOfAffineIcp(const KernelProblem& problem, const RigidTransform& start,
                                     const AffineOptions& options, const KernelObserver& observe)
{
    KernelPnpResult result;
    result.pose = start;
    KernelDistances atStart;
    measureDistances(problem, start, atStart);
    std::vector<Eigen::Vector3d> points;
    for (const Eigen::Vector3d& point : atStart.inCamera) {
        if (point.z() > minProjectableDepthMm) {
            points.push_back(point);
        }
    }
    AffineRows map;
    double loss = std::numeric_limits<double>::infinity();
    while (result.iterations < options.maxIterations) {
        const Round round = accumulateRound(problem, points, map, options.huberPx);
        if (!(round.loss < (1.0 - settledAffineShare) * loss)) {
            result.stopReason = StopReason::Converged;
            break;
        }
        loss = round.loss;
        const auto solver = round.squares.ldlt();
        map = {solver.solve(round.towardsX), solver.solve(round.towardsY)};
        ++result.iterations;
        if (observe && observe({result.iterations, options.huberPx, start, &atStart}) == ObserverDecision::Stop) {
            result.stopReason = StopReason::StoppedByUser;
            return result;
        }
    }
    result.pose = rigidPart(problem, start, map);
    return result;
}

}   // namespace angiopose::core
