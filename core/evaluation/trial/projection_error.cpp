#include "core/evaluation/trial/projection_error.h"

#include "core/geometry/angle_units.h"
#include "core/support/quantile.h"
#include "core/support/symmetric.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace angiopose::core {
namespace {

/// Returns the distance from `point` to the line through the source and `onRay`, in the camera frame.
double distanceToRay(const Eigen::Vector3d& point, const Eigen::Vector3d& onRay)
{
    const Eigen::Vector3d direction = onRay.normalized();
    return (point - point.dot(direction) * direction).norm();
}

std::vector<Eigen::Vector3d> transformedPoints(const VesselTree& tree, const RigidTransform& pose)
{
    std::vector<Eigen::Vector3d> points;
    points.reserve(tree.pointCount());
    for (const VesselBranch& branch : tree.branches) {
        std::ranges::transform(branch.pointsInPatient, std::back_inserter(points),
                               [&](const Eigen::Vector3d& point) { return pose * point; });
    }
    return points;
}

}   // namespace

CorrespondingPoints correspondingPoints(const VesselTree& tree, const PosePair& poses)
{
    return correspondingPoints(tree, tree, poses);
}

CorrespondingPoints correspondingPoints(const VesselTree& found, const VesselTree& truth, const PosePair& poses)
{
    return {transformedPoints(found, poses.estimate), transformedPoints(truth, poses.truth)};
}

std::vector<double> projectionDistancesPx(const VesselTree& tree, const ProjectionCamera& camera, const PosePair& poses)
{
    return projectionDistancesPx(camera, correspondingPoints(tree, poses));
}

std::vector<double> projectionDistancesPx(const ProjectionCamera& camera, const CorrespondingPoints& points)
{
    std::vector<double> distances;
    distances.reserve(points.truth.size());
    for (std::size_t i = 0; i < points.truth.size(); ++i) {
        const auto partner = project(camera, points.truth[i]);
        if (!partner) {
            continue;
        }
        const auto found = project(camera, points.found[i]);
        distances.push_back(found ? (*found - *partner).norm() : std::numeric_limits<double>::infinity());
    }
    return distances;
}

ProjectionError projectionError(const VesselTree& tree, const ProjectionCamera& camera, const PosePair& poses)
{
    return projectionError(camera, correspondingPoints(tree, poses), (poses.truth * centroidInPatient(tree)).z());
}

ProjectionError projectionError(const ProjectionCamera& camera, const CorrespondingPoints& points, double depthMm)
{
    const std::vector<double> distances = projectionDistancesPx(camera, points);
    const auto count = static_cast<double>(distances.size());
    double sum = 0.0;
    double sumOfSquares = 0.0;
    for (const double distance : distances) {
        sum += distance;
        sumOfSquares += distance * distance;
    }
    const std::vector<double> shares = quantiles(distances, {0.5, 0.75, 0.95});
    const double mmPerPx = millimetersPerPixel(camera, depthMm);

    ProjectionError error;
    error.meanPx = sum / count;
    error.rmsPx = std::sqrt(sumOfSquares / count);
    error.medianPx = shares[0];
    error.p75Px = shares[1];
    error.p95Px = shares[2];
    error.meanMm = error.meanPx * mmPerPx;
    error.rmsMm = error.rmsPx * mmPerPx;
    error.medianMm = error.medianPx * mmPerPx;
    error.p75Mm = error.p75Px * mmPerPx;
    error.p95Mm = error.p95Px * mmPerPx;
    return error;
}

std::vector<Eigen::Vector3d> targetsOf(const VesselTree& tree)
{
    std::vector<Eigen::Vector3d> targets;
    targets.reserve(tree.pointCount() + 8);
    for (const VesselBranch& branch : tree.branches) {
        targets.insert(targets.end(), branch.pointsInPatient.begin(), branch.pointsInPatient.end());
    }
    if (targets.empty()) {
        return targets;
    }
    Eigen::Vector3d low = targets.front();
    Eigen::Vector3d high = targets.front();
    for (const Eigen::Vector3d& point : targets) {
        low = low.cwiseMin(point);
        high = high.cwiseMax(point);
    }
    for (int corner = 0; corner < 8; ++corner) {
        targets.emplace_back(corner & 1 ? high.x() : low.x(), corner & 2 ? high.y() : low.y(),
                             corner & 4 ? high.z() : low.z());
    }
    return targets;
}

TargetError targetError(const std::vector<Eigen::Vector3d>& targetsInPatient, const PosePair& poses)
{
    CorrespondingPoints targets;
    for (const Eigen::Vector3d& target : targetsInPatient) {
        targets.found.push_back(poses.estimate * target);
        targets.truth.push_back(poses.truth * target);
    }
    return targetError(targets);
}

TargetError targetError(const CorrespondingPoints& targets)
{
    TargetError error;
    for (std::size_t i = 0; i < targets.truth.size(); ++i) {
        const Eigen::Vector3d& found = targets.found[i];
        const Eigen::Vector3d& truth = targets.truth[i];
        error.mtreMm += (found - truth).norm();
        error.mtreInPlaneMm += (found - truth).head<2>().norm();
        error.mrpdMm += distanceToRay(truth, found);
    }
    const auto count = static_cast<double>(targets.truth.size());
    error.mtreMm /= count;
    error.mtreInPlaneMm /= count;
    error.mrpdMm /= count;
    return error;
}

Vector6d errorAboutCentroid(const Eigen::Vector3d& centroidInPatient, const PosePair& poses)
{
    Vector6d error;
    error << logSo3(poses.estimate.rotation * poses.truth.rotation.transpose()),
        poses.estimate * centroidInPatient - poses.truth * centroidInPatient;
    return error;
}

PoseError poseError(const Eigen::Vector3d& centroidInPatient, const PosePair& poses)
{
    const Vector6d error = errorAboutCentroid(centroidInPatient, poses);
    PoseError result;
    result.angleDeg = error.head<3>().norm() * degreesPerRadian;
    result.outOfPlaneDeg = error.head<2>().norm() * degreesPerRadian;
    result.inPlaneDeg = error(2) * degreesPerRadian;
    result.centroidMm = error.tail<3>().norm();
    result.centroidInPlaneMm = error.segment<2>(3).norm();
    result.centroidDepthMm = error(5);
    result.seedDistanceMm = (poses.estimate * poses.truth.inverse()).translation.norm();
    return result;
}

double normalizedErrorSquared(const Vector6d& error, const Matrix6d& covariance)
{
    return error.dot(solveSymmetric(covariance, error));
}

}   // namespace angiopose::core
