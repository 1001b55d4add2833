#include "core/registration/pose/initial_pose_prior.h"

#include <gtest/gtest.h>

namespace angiopose::core {
namespace {

CentroidPose someCentroidPose()
{
    return {expSo3({0.3, -0.2, 0.7}), {5.0, -8.0, 790.0}};
}

TEST(CentroidPose, GoesToAPoseAndBack)
{
    const Eigen::Vector3d centroid(12.0, -70.0, 300.0);
    const RigidTransform pose = cameraFromPatient(someCentroidPose(), centroid);
    EXPECT_LT((pose * centroid - someCentroidPose().centroidInCamera).norm(), 1e-12);
    const CentroidPose back = aboutCentroid(pose, centroid);
    EXPECT_LT((back.rotation - someCentroidPose().rotation).norm(), 1e-14);
    EXPECT_LT((back.centroidInCamera - someCentroidPose().centroidInCamera).norm(), 1e-11);
}

TEST(CentroidPose, StepBetweenUndoesMoved)
{
    Vector6d step;
    step << 0.1, -0.05, 0.2, 3.0, -4.0, 20.0;
    EXPECT_LT((stepBetween(someCentroidPose(), retract(someCentroidPose(), step)) - step).norm(), 1e-12);
}

TEST(InitialPosePrior, GradientMatchesDifferencesOfItsCost)
{
    Vector6d std;
    std << 0.14, 0.2, 1.05, 30.0, 20.0, 60.0;
    InitialPosePrior prior = independentPrior(someCentroidPose(), std);
    const Vector6d shared = 0.7 / 20.0 * Vector6d::Unit(4) + 0.7 / 0.14 * Vector6d::Unit(0);
    prior.information += shared * shared.transpose();
    Vector6d away;
    away << 0.2, -0.15, 0.3, 10.0, -4.0, 25.0;
    const CentroidPose pose = retract(someCentroidPose(), away);
    NormalEquations equations;
    prior.add(pose, 1.0, equations);
    for (int k = 0; k < 6; ++k) {
        constexpr double h = 1e-6;
        const Vector6d step = h * Vector6d::Unit(k);
        const double slope = (prior.cost(retract(pose, step)) - prior.cost(retract(pose, -step))) / (2.0 * h);
        EXPECT_NEAR(2.0 * equations.gradient[k], slope, 1e-5 * std::max(1.0, std::abs(slope)));
    }
}

TEST(InitialPosePrior, InformationIsTheCurvatureOfItsCost)
{
    const InitialPosePrior prior = initialPosePrior(someCentroidPose(), {});
    Vector6d away;
    away << 0.2, -0.15, 0.3, 10.0, -4.0, 25.0;
    NormalEquations equations;
    prior.add(retract(someCentroidPose(), away), 1.0, equations);
    EXPECT_LT((equations.hessian - prior.informationAt(retract(someCentroidPose(), away))).norm(), 1e-9);
    EXPECT_LT((prior.std() - independentPrior(someCentroidPose(), prior.std()).std()).norm(), 1e-9);
    EXPECT_DOUBLE_EQ(prior.std()[5], RegistrationOptions().angiopose.priorDepthMm);
}

}   // namespace
}   // namespace angiopose::core
