#include "core/geometry/rigid_transform.h"

#include <Eigen/LU>
#include <Eigen/SVD>
#include <cmath>
#include <numbers>

namespace angiopose::core {
namespace {

constexpr double smallAngle = 1e-5;

/// Returns the left Jacobian of SO(3), which maps upsilon to the translation of the SE(3) exponential.
Eigen::Matrix3d leftJacobianSo3(const Eigen::Vector3d& omega)
{
    const double angle = omega.norm();
    const Eigen::Matrix3d hat = skew(omega);
    if (angle < smallAngle) {
        return Eigen::Matrix3d::Identity() + 0.5 * hat + hat * hat / 6.0;
    }
    const double angle2 = angle * angle;
    const double halfSine = std::sin(0.5 * angle);
    return Eigen::Matrix3d::Identity() + (2.0 * halfSine * halfSine / angle2) * hat +
           ((angle - std::sin(angle)) / (angle2 * angle)) * hat * hat;
}

/// Returns the coupling block Q of the left Jacobian of SE(3) (Barfoot, State Estimation for Robotics, eq. 7.86).
Eigen::Matrix3d couplingBlock(const Eigen::Vector3d& omega, const Eigen::Vector3d& upsilon)
{
    const Eigen::Matrix3d w = skew(omega);
    const Eigen::Matrix3d v = skew(upsilon);
    const double angle = omega.norm();
    double a = 1.0 / 6.0;
    double b = 1.0 / 24.0;
    double c = 1.0 / 120.0;
    if (angle > 1e-2) {   // below this angle the closed forms suffer cancellation; the series is accurate to 1e-9
        const double angle2 = angle * angle;
        const double sine = std::sin(angle);
        const double cosine = std::cos(angle);
        a = (angle - sine) / (angle2 * angle);
        b = (angle2 + 2.0 * cosine - 2.0) / (2.0 * angle2 * angle2);
        c = (2.0 * angle - 3.0 * sine + angle * cosine) / (2.0 * angle2 * angle2 * angle);
    } else {
        const double angle2 = angle * angle;
        a -= angle2 / 120.0;
        b -= angle2 / 720.0;
        c -= angle2 / 2520.0;
    }
    const Eigen::Matrix3d wv = w * v;
    const Eigen::Matrix3d vw = v * w;
    const Eigen::Matrix3d wvw = wv * w;
    return 0.5 * v + a * (wv + vw + wvw) + b * (w * wv + vw * w - 3.0 * wvw) + c * (wvw * w + w * wvw);
}

}   // namespace

RigidTransform RigidTransform::inverse() const
{
    const Eigen::Matrix3d transposed = rotation.transpose();
    return {transposed, -(transposed * translation)};
}

Eigen::Matrix4d RigidTransform::matrix() const
{
    Eigen::Matrix4d result = Eigen::Matrix4d::Identity();
    result.topLeftCorner<3, 3>() = rotation;
    result.topRightCorner<3, 1>() = translation;
    return result;
}

Eigen::Matrix3d skew(const Eigen::Vector3d& vector)
{
    Eigen::Matrix3d result;
    result << 0.0, -vector.z(), vector.y(), vector.z(), 0.0, -vector.x(), -vector.y(), vector.x(), 0.0;
    return result;
}

Eigen::Matrix3d expSo3(const Eigen::Vector3d& omega)
{
    const double angle = omega.norm();
    const Eigen::Matrix3d hat = skew(omega);
    if (angle < smallAngle) {
        return Eigen::Matrix3d::Identity() + hat + 0.5 * hat * hat;
    }
    const double halfSine = std::sin(0.5 * angle);
    return Eigen::Matrix3d::Identity() + (std::sin(angle) / angle) * hat +
           (2.0 * halfSine * halfSine / (angle * angle)) * hat * hat;
}

Eigen::Vector3d logSo3(const Eigen::Matrix3d& rotation)
{
    Eigen::Quaterniond q(rotation);   // uses the largest component first, which keeps the conversion stable near 180°
    if (q.w() < 0.0) {
        q.coeffs() = -q.coeffs();
    }
    const double sineOfHalf = q.vec().norm();
    if (sineOfHalf < 1e-12) {
        return 2.0 * q.vec();
    }
    return (2.0 * std::atan2(sineOfHalf, q.w()) / sineOfHalf) * q.vec();
}

Eigen::Matrix3d inverseLeftJacobianSo3(const Eigen::Vector3d& omega)
{
    const double angle = omega.norm();
    const Eigen::Matrix3d hat = skew(omega);
    if (angle < smallAngle) {
        return Eigen::Matrix3d::Identity() - 0.5 * hat + hat * hat / 12.0;
    }
    const double half = 0.5 * angle;
    const double factor = (1.0 - half * std::cos(half) / std::sin(half)) / (angle * angle);
    return Eigen::Matrix3d::Identity() - 0.5 * hat + factor * hat * hat;
}

RigidTransform expSe3(const Vector6d& twist)
{
    const Eigen::Vector3d omega = twist.head<3>();
    return {expSo3(omega), leftJacobianSo3(omega) * twist.tail<3>()};
}

Vector6d logSe3(const RigidTransform& transform)
{
    const Eigen::Vector3d omega = logSo3(transform.rotation);
    Vector6d twist;
    twist << omega, inverseLeftJacobianSo3(omega) * transform.translation;
    return twist;
}

Matrix6d adjoint(const RigidTransform& transform)
{
    Matrix6d result = Matrix6d::Zero();
    result.topLeftCorner<3, 3>() = transform.rotation;
    result.bottomRightCorner<3, 3>() = transform.rotation;
    result.bottomLeftCorner<3, 3>() = skew(transform.translation) * transform.rotation;
    return result;
}

Matrix6d inverseRightJacobianSe3(const Vector6d& twist)
{
    // Jr(x) = Jl(-x); the inverse of the block-triangular Jl follows from its diagonal blocks.
    const Eigen::Vector3d omega = -twist.head<3>();
    const Eigen::Vector3d upsilon = -twist.tail<3>();
    const Eigen::Matrix3d inverseDiagonal = inverseLeftJacobianSo3(omega);
    Matrix6d result = Matrix6d::Zero();
    result.topLeftCorner<3, 3>() = inverseDiagonal;
    result.bottomRightCorner<3, 3>() = inverseDiagonal;
    result.bottomLeftCorner<3, 3>() = -inverseDiagonal * couplingBlock(omega, upsilon) * inverseDiagonal;
    return result;
}

Eigen::Matrix3d nearestRotation(const Eigen::Matrix3d& matrix)
{
    const Eigen::JacobiSVD<Eigen::Matrix3d> svd(matrix, Eigen::ComputeFullU | Eigen::ComputeFullV);
    Eigen::Vector3d signs = Eigen::Vector3d::Ones();
    signs.z() = (svd.matrixU() * svd.matrixV().transpose()).determinant() < 0.0 ? -1.0 : 1.0;
    return svd.matrixU() * signs.asDiagonal() * svd.matrixV().transpose();
}

double angleBetween(const Eigen::Matrix3d& a, const Eigen::Matrix3d& b)
{
    return logSo3(a * b.transpose()).norm();
}

bool isRigid(const RigidTransform& transform, double tolerance)
{
    const Eigen::Matrix3d& r = transform.rotation;
    return r.allFinite() && transform.translation.allFinite() &&
           (r * r.transpose() - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff() < tolerance && r.determinant() > 0.0;
}

}   // namespace angiopose::core
