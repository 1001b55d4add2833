#include "tests/benchmark/known_pose.h"

#include "core/registration/deformable/deformed_result.h"

#include <Eigen/Cholesky>

namespace angiopose::benchmarks {
namespace {

std::vector<Eigen::Vector3d> allPoints(const core::VesselTree& tree)
{
    std::vector<Eigen::Vector3d> points;
    for (const core::VesselBranch& branch : tree.branches) {
        points.insert(points.end(), branch.pointsInPatient.begin(), branch.pointsInPatient.end());
    }
    return points;
}

}   // namespace

core::RigidTransform nearestPoseInSpace(const DeformedCase& deformedCase)
{
    const std::vector<Eigen::Vector3d> points = allPoints(deformedCase.tree);
    return deformedCase.views.front().truth *
           core::fitRigidTransform(points, allPoints(deformedCase.deformed), std::vector<double>(points.size(), 1.0));
}

core::RigidTransform bestRigidPose(const DeformedCase& deformedCase)
{
    const DeformedView& view = deformedCase.views.front();
    const std::vector<Eigen::Vector3d> points = allPoints(deformedCase.tree);
    const std::vector<Eigen::Vector3d> truths = allPoints(deformedCase.deformed);
    const core::RigidTransform inSpace = nearestPoseInSpace(deformedCase);
    if (deformedCase.views.size() > 1) {
        return inSpace;
    }
    core::RigidTransform pose = inSpace;
    for (int step = 0; step < 20; ++step) {
        core::Matrix6d hessian = 1e-6 * core::Matrix6d::Identity();
        core::Vector6d gradient = core::Vector6d::Zero();
        for (std::size_t i = 0; i < points.size(); ++i) {
            const Eigen::Vector3d found = pose * points[i];
            const auto pixel = core::project(view.camera, found);
            const auto truth = core::project(view.camera, view.truth * truths[i]);
            if (pixel && truth) {
                Eigen::Matrix<double, 3, 6> byStep;
                byStep << -core::skew(found), Eigen::Matrix3d::Identity();
                const Eigen::Matrix<double, 2, 6> jacobian = core::projectionJacobian(view.camera, found) * byStep;
                hessian += jacobian.transpose() * jacobian;
                gradient += jacobian.transpose() * (*truth - *pixel);
            }
        }
        pose = core::expSe3(hessian.ldlt().solve(gradient)) * pose;
    }
    return pose;
}

}   // namespace angiopose::benchmarks
