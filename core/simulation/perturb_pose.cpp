#include "core/simulation/simulated_case.h"

#include "core/geometry/angle_units.h"

namespace angiopose::core {
namespace {

Eigen::Vector3d normalVector(double standardDeviation, CounterRandom& random)
{
    const double x = random.normal();
    const double y = random.normal();
    const double z = random.normal();
    return standardDeviation * Eigen::Vector3d(x, y, z);
}

Eigen::Vector3d uniformVector(double range, CounterRandom& random)
{
    const double x = random.uniform(-range, range);
    const double y = random.uniform(-range, range);
    const double z = random.uniform(-range, range);
    return {x, y, z};
}

RigidTransform displaced(const RigidTransform& cameraFromPatient, const Eigen::Vector3d& centroidInPatient,
                         const Eigen::Vector3d& omega, const Eigen::Vector3d& shift)
{
    const Eigen::Matrix3d rotation = expSo3(omega) * cameraFromPatient.rotation;
    return {rotation, cameraFromPatient * centroidInPatient + shift - rotation * centroidInPatient};
}

}   // namespace

RigidTransform perturbAboutCentroid(const RigidTransform& cameraFromPatient, const Eigen::Vector3d& centroidInPatient,
                                    double rotationStdDeg, double translationStdMm, CounterRandom& random)
{
    const Eigen::Vector3d omega = normalVector(rotationStdDeg * radiansPerDegree, random);
    const Eigen::Vector3d shift = normalVector(translationStdMm, random);
    return displaced(cameraFromPatient, centroidInPatient, omega, shift);
}

RigidTransform displaceUniformly(const RigidTransform& cameraFromPatient, const Eigen::Vector3d& centroidInPatient,
                                 double rangeDeg, double rangeMm, CounterRandom& random)
{
    const Eigen::Vector3d omega = uniformVector(rangeDeg * radiansPerDegree, random);
    const Eigen::Vector3d shift = uniformVector(rangeMm, random);
    return displaced(cameraFromPatient, centroidInPatient, omega, shift);
}

RigidTransform perturbAboutSource(const RigidTransform& cameraFromPatient, double rotationStdDeg,
                                  double translationStdMm, CounterRandom& random)
{
    Vector6d twist;
    twist.head<3>() = normalVector(rotationStdDeg * radiansPerDegree, random);
    twist.tail<3>() = normalVector(translationStdMm, random);
    return expSe3(twist) * cameraFromPatient;
}

}   // namespace angiopose::core
