#include "core/evaluation/trial/cramer_rao_bound.h"

#include "core/registration/judging/branch_information.h"
#include "core/support/symmetric.h"

#include <cmath>

namespace angiopose::core {
namespace {

using PixelJacobian = Eigen::Matrix<double, 2, 6>;

/// Returns the derivative d(pixel)/d(rotation, shift) of a point rotated about `center` and shifted, in camera axes.
PixelJacobian pixelJacobian(const ProjectionCamera& camera, const Eigen::Vector3d& pointInCamera,
                            const Eigen::Vector3d& center)
{
    Eigen::Matrix<double, 3, 6> motion;
    motion << -skew(pointInCamera - center), Eigen::Matrix3d::Identity();
    return projectionJacobian(camera, pointInCamera) * motion;
}

/// Returns the variance of the mean over many points, times their number; correlated noise averages out slowly.
double effectiveVariancePx2(const TracingNoise& noise)
{
    const double correlation = noise.correlationPoints > 0.0 ? std::exp(-1.0 / noise.correlationPoints) : 0.0;
    const double rounding = noise.isRasterized ? 1.0 / 12.0 : 0.0;
    return noise.jitterPx * noise.jitterPx * (1.0 + correlation) / (1.0 - correlation) + rounding;
}

}   // namespace

Matrix6d cramerRaoBound(const VesselTree& tree, const VesselTree& visible, const ProjectionCamera& camera,
                        const RigidTransform& cameraFromPatient, const TracingNoise& noise)
{
    const Eigen::Vector3d center = cameraFromPatient * centroidInPatient(tree);
    Matrix6d information = Matrix6d::Zero();
    for (const VesselBranch& branch : visible.branches) {
        for (std::size_t i = 1; i < branch.pointsInPatient.size(); ++i) {
            const Eigen::Vector3d from = cameraFromPatient * branch.pointsInPatient[i - 1];
            const Eigen::Vector3d to = cameraFromPatient * branch.pointsInPatient[i];
            information += segmentInformation(camera, from, to, center);
        }
    }
    return effectiveVariancePx2(noise) * inverseOf(information);
}

double rmsProjectionPx(const VesselTree& tree, const ProjectionCamera& camera, const RigidTransform& cameraFromPatient,
                       const Matrix6d& covariance)
{
    const Eigen::Vector3d center = cameraFromPatient * centroidInPatient(tree);
    double squares = 0.0;
    for (const VesselBranch& branch : tree.branches) {
        for (const Eigen::Vector3d& point : branch.pointsInPatient) {
            const PixelJacobian jacobian = pixelJacobian(camera, cameraFromPatient * point, center);
            squares += (jacobian * covariance * jacobian.transpose()).trace();
        }
    }
    return std::sqrt(squares / static_cast<double>(tree.pointCount()));
}

}   // namespace angiopose::core
