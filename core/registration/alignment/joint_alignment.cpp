#include "core/registration/alignment/joint_alignment.h"

namespace angiopose::core {

CentroidPose poseInView(const JointPose& joint, std::span<const RelativeCamera> geometry, std::size_t view)
{
    const RigidTransform& there = geometry[view].cameraFromFirst;
    const CentroidPose carried{there.rotation * joint.first.rotation, there * joint.first.centroidInCamera};
    return retract(carried, joint.corrections[view]);
}

namespace {

/// Returns the Jacobian of a view's pose step with respect to a step of the first view's pose.
Matrix6d viewStepJacobian(const JointPose& joint, std::span<const RelativeCamera> geometry, std::size_t view)
{
    const Eigen::Matrix3d& turn = geometry[view].cameraFromFirst.rotation;
    Matrix6d J = Matrix6d::Zero();
    J.topLeftCorner<3, 3>() = expSo3(joint.corrections[view].head<3>()) * turn;
    J.bottomRightCorner<3, 3>() = turn;
    return J;
}

}   // namespace

StackedEquations stackEquations(std::span<const NormalEquations> perView, const JointPose& joint,
                                std::span<const RelativeCamera> geometry)
{
    const auto count = static_cast<Eigen::Index>(6 * perView.size());
    StackedEquations sum{Eigen::MatrixXd::Zero(count, count), Eigen::VectorXd::Zero(count)};
    for (std::size_t k = 0; k < perView.size(); ++k) {
        const Matrix6d H = perView[k].hessian.selfadjointView<Eigen::Lower>();
        const Matrix6d J = viewStepJacobian(joint, geometry, k);
        sum.hessian.topLeftCorner<6, 6>() += J.transpose() * H * J;
        sum.gradient.head<6>() += J.transpose() * perView[k].gradient;
        if (k > 0) {
            const auto at = static_cast<Eigen::Index>(6 * k);
            sum.hessian.block<6, 6>(at, at) += H;
            sum.hessian.block<6, 6>(at, 0) += H * J;
            sum.hessian.block<6, 6>(0, at) += J.transpose() * H;
            sum.gradient.segment<6>(at) += perView[k].gradient;
        }
    }
    return sum;
}

StackedEquations stackEquations(std::span<const CameraEquations> perView, const JointPose& joint,
                                std::span<const RelativeCamera> geometry)
{
    std::vector<NormalEquations> ofPoses;
    for (const CameraEquations& view : perView) {
        ofPoses.push_back({view.hessian.topLeftCorner<6, 6>(), view.gradient.head<6>()});
    }
    const StackedEquations poses = stackEquations(ofPoses, joint, geometry);
    const Eigen::Index poseCount = poses.hessian.rows();
    const auto count = poseCount + static_cast<Eigen::Index>(3 * perView.size());
    StackedEquations sum{Eigen::MatrixXd::Zero(count, count), Eigen::VectorXd::Zero(count)};
    sum.hessian.topLeftCorner(poseCount, poseCount) = poses.hessian;
    sum.gradient.head(poseCount) = poses.gradient;
    for (std::size_t k = 0; k < perView.size(); ++k) {
        const auto at = poseCount + static_cast<Eigen::Index>(3 * k);
        const Eigen::Matrix<double, 3, 6> crossed = perView[k].hessian.bottomLeftCorner<3, 6>();
        sum.hessian.block<3, 3>(at, at) = perView[k].hessian.bottomRightCorner<3, 3>();
        sum.hessian.block<3, 6>(at, 0) = crossed * viewStepJacobian(joint, geometry, k);
        if (k > 0) {
            sum.hessian.block<3, 6>(at, static_cast<Eigen::Index>(6 * k)) = crossed;
        }
        sum.gradient.segment<3>(at) = perView[k].gradient.tail<3>();
    }
    const Eigen::MatrixXd lower = sum.hessian.triangularView<Eigen::Lower>();
    sum.hessian = lower.selfadjointView<Eigen::Lower>();
    return sum;
}

JointPose retract(const JointPose& joint, const Eigen::VectorXd& step)
{
    JointPose result{retract(joint.first, step.head<6>()), joint.corrections};
    for (std::size_t k = 1; k < result.corrections.size(); ++k) {
        const Vector6d own = step.segment<6>(static_cast<Eigen::Index>(6 * k));
        const Vector6d before = joint.corrections[k];
        result.corrections[k].head<3>() = logSo3(expSo3(own.head<3>()) * expSo3(before.head<3>()));
        result.corrections[k].tail<3>() = before.tail<3>() + own.tail<3>();
    }
    return result;
}

}   // namespace angiopose::core
