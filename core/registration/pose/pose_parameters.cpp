#include "core/registration/pose/pose_parameters.h"

#include <cmath>
#include <numbers>

namespace core {
namespace {

/// exp(ω + d) ≈ exp(J d) exp(ω).
Eigen::Matrix3d leftJacobianSo3(const Eigen::Vector3d& omega)
{
    const double angle = omega.norm();
    const Eigen::Matrix3d cross = skew(omega);
    if (angle < 1e-4) {
        return Eigen::Matrix3d::Identity() + 0.5 * cross + cross * cross / 6.0;
    }
    return Eigen::Matrix3d::Identity() + (1.0 - std::cos(angle)) / (angle * angle) * cross +
           (angle - std::sin(angle)) / (angle * angle * angle) * cross * cross;
}

}   // namespace

Vector6d PoseParameters::gradient(const Vector6d& x, const Vector6d& stepGradient) const
{
    const Eigen::Vector3d omega = x.head<3>().cwiseProduct(unit_.head<3>());
    Vector6d gradient = stepGradient;
    gradient.head<3>() = leftJacobianSo3(omega).transpose() * stepGradient.head<3>();
    return gradient.cwiseProduct(unit_);
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

}   // namespace core
