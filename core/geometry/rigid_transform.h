#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace angiopose::core {

using Vector6d = Eigen::Matrix<double, 6, 1>;
using Matrix6d = Eigen::Matrix<double, 6, 6>;

/// Rigid transform, lengths in mm. Variables are named after the frames they connect: `cameraFromPatient *
/// pointInPatient = pointInCamera`.
struct RigidTransform {
    Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
    Eigen::Vector3d translation = Eigen::Vector3d::Zero();

    RigidTransform operator*(const RigidTransform& other) const
    {
        return {rotation * other.rotation, rotation * other.translation + translation};
    }
    Eigen::Vector3d operator*(const Eigen::Vector3d& point) const { return rotation * point + translation; }

    RigidTransform inverse() const;
    Eigen::Matrix4d matrix() const;
};

/// Returns the 3×3 matrix with `skew(a) * b == a × b`.
Eigen::Matrix3d skew(const Eigen::Vector3d& vector);

/// Returns the rotation by |omega| rad about omega; exact for any angle, using a series near zero.
Eigen::Matrix3d expSo3(const Eigen::Vector3d& omega);

/// Returns the rotation vector, |omega| ≤ π; inverse of expSo3, stable up to and including π.
Eigen::Vector3d logSo3(const Eigen::Matrix3d& rotation);

/// Returns the inverse left Jacobian of SO(3): `log(exp(x) R) ≈ log(R) + Jl^-1(log R) x`.
Eigen::Matrix3d inverseLeftJacobianSo3(const Eigen::Vector3d& omega);

/// Returns the exact exponential of a twist (omega in rad, upsilon in mm).
RigidTransform expSe3(const Vector6d& twist);

/// Returns the exact logarithm, a twist (omega in rad, upsilon in mm).
Vector6d logSe3(const RigidTransform& transform);

/// Returns the adjoint for twists ordered (omega, upsilon): `T exp(x) T^-1 = exp(Ad(T) x)`.
Matrix6d adjoint(const RigidTransform& transform);

/// Returns the inverse right Jacobian of SE(3): `log(T exp(x)) ≈ log(T) + Jr^-1(log T) x`.
Matrix6d inverseRightJacobianSe3(const Vector6d& twist);

/// Returns the rotation nearest to `matrix` (Frobenius norm), with determinant +1.
Eigen::Matrix3d nearestRotation(const Eigen::Matrix3d& matrix);

/// Returns the angle in rad between two orientations.
double angleBetween(const Eigen::Matrix3d& a, const Eigen::Matrix3d& b);

/// Whether all entries are finite and the rotation is orthonormal with determinant +1, within `tolerance`.
bool isRigid(const RigidTransform& transform, double tolerance = 1e-4);

}   // namespace angiopose::core
