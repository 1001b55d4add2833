#include "core/registration/pose/pose_parameters.h"

#include <numbers>

namespace angiopose::core {
namespace {

/// Returns the freedom; without locks, measures its angles from the origin, where they are independent.
PoseFreedom relativeTo(const CentroidPose& origin, const PoseFreedom& freedom)
{
    return freedom.isFull() ? PoseFreedom({}, {origin.rotation, {0.0, 0.0, 0.0}}, origin) : freedom;
}

}   // namespace

PoseParameters::PoseParameters(const CentroidPose& origin, const Vector6d& unit, const PoseFreedom& freedom)
    : freedom_(relativeTo(origin, freedom)), origin_(freedom_.coordinates(origin)), unit_(unit)
{
    for (Eigen::Index k = 0; k < unit.size(); ++k) {
        if (!freedom.isLocked(k)) {
            free_.push_back(k);
        }
    }
}

CentroidPose PoseParameters::pose(const Eigen::VectorXd& x) const
{
    Vector6d coordinates = origin_;
    for (Eigen::Index i = 0; i < count(); ++i) {
        const Eigen::Index k = free_[static_cast<std::size_t>(i)];
        coordinates[k] += unit_[k] * x[i];
    }
    return freedom_.restoreLockedAxes(freedom_.poseAt(coordinates));
}

Eigen::VectorXd PoseParameters::gradient(const Eigen::VectorXd& x, const Vector6d& stepGradient) const
{
    const Vector6d ofCoordinates = freedom_.stepsPerCoordinate(pose(x)).transpose() * stepGradient;
    Eigen::VectorXd gradient(count());
    for (Eigen::Index i = 0; i < count(); ++i) {
        const Eigen::Index k = free_[static_cast<std::size_t>(i)];
        gradient[i] = unit_[k] * ofCoordinates[k];
    }
    return gradient;
}

Vector6d metricUnits(double spreadMm)
{
    Vector6d unit = Vector6d::Ones();
    unit.head<3>().setConstant(1.0 / spreadMm);
    return unit;
}

Vector6d clinicalUnits(double tiltDeg, double rollDeg, double lateralMm, double depthMm)
{
    constexpr double perDeg = std::numbers::pi / 180.0;
    Vector6d unit;
    unit << tiltDeg * perDeg, tiltDeg * perDeg, rollDeg * perDeg, lateralMm, lateralMm, depthMm;
    return unit;
}

}   // namespace angiopose::core
