#include "core/simulation/fit_pose_to_correspondences.h"

#include "core/support/symmetric.h"

#include <cassert>

namespace angiopose::core {

RigidTransform fitPoseToCorrespondences(const std::vector<Eigen::Vector3d>& pointsInPatient,
                                        const std::vector<Eigen::Vector2d>& pixels, const ProjectionCamera& camera,
                                        const RigidTransform& start)
{
    assert(pointsInPatient.size() == pixels.size());
    Eigen::Vector3d centroid = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& point : pointsInPatient) {
        centroid += point / static_cast<double>(pointsInPatient.size());
    }
    RigidTransform pose = start;
    // Gauss–Newton about the centroid (OBJ parameters, ALGORITHMS §1); the initial pose is at most a few pixels off.
    for (int iteration = 0; iteration < 20; ++iteration) {
        Matrix6d hessian = Matrix6d::Zero();
        Vector6d gradient = Vector6d::Zero();
        const Eigen::Vector3d center = pose * centroid;
        for (std::size_t i = 0; i < pixels.size(); ++i) {
            const Eigen::Vector3d x = pose * pointsInPatient[i];
            const std::optional<Eigen::Vector2d> pixel = project(camera, x);
            if (!pixel) {
                continue;
            }
            Eigen::Matrix<double, 3, 6> motion;
            motion << -skew(x - center), Eigen::Matrix3d::Identity();
            const Eigen::Matrix<double, 2, 6> jacobian = projectionJacobian(camera, x) * motion;
            hessian += jacobian.transpose() * jacobian;
            gradient += jacobian.transpose() * (*pixel - pixels[i]);
        }
        const Vector6d step = -solveSymmetric(hessian, gradient);
        const Eigen::Matrix3d rotation = expSo3(step.head<3>()) * pose.rotation;
        pose = {rotation, center + step.tail<3>() - rotation * centroid};
        if (step.norm() < 1e-12) {
            break;
        }
    }
    return pose;
}

}   // namespace angiopose::core
