#include "core/geometry/rigid_transform.h"

#include "core/support/random.h"

#include <gtest/gtest.h>
#include <numbers>

using namespace angiopose;

namespace {

using namespace core;

Vector6d randomTwist(CounterRandom& random, double angle)
{
    Eigen::Vector3d axis(random.normal(), random.normal(), random.normal());
    Vector6d twist;
    twist << angle * axis.normalized(), 50.0 * random.normal(), 50.0 * random.normal(), 800.0 * random.normal();
    return twist;
}

TEST(RigidTransform, LogInvertsExpForEveryAngleBelowAHalfTurn)
{
    CounterRandom random(1);
    for (const double angle :
         {0.0, 1e-12, 1e-8, 1e-6, 1e-5, 1e-4, 1e-2, 0.5, 2.0, 3.0, 3.1415, std::numbers::pi - 1e-7}) {
        const Vector6d twist = randomTwist(random, angle);
        const Vector6d back = logSe3(expSe3(twist));
        EXPECT_LT((back - twist).norm(), 1e-6 * (1.0 + twist.norm())) << "angle " << angle;
        EXPECT_LT((back.head<3>() - twist.head<3>()).norm(), 1e-9) << "angle " << angle;
    }
}

TEST(RigidTransform, LogOfAHalfTurnHasAngleOfPi)
{
    const Eigen::Vector3d axis = Eigen::Vector3d(1.0, -2.0, 0.5).normalized();
    const Eigen::Vector3d omega = logSo3(expSo3(std::numbers::pi * axis));
    EXPECT_NEAR(omega.norm(), std::numbers::pi, 1e-12);
    EXPECT_NEAR(std::abs(omega.normalized().dot(axis)), 1.0, 1e-12);
}

TEST(RigidTransform, ExpOfAPureTranslationIsThatTranslation)
{
    Vector6d twist;
    twist << 0.0, 0.0, 0.0, 1.0, 2.0, 3.0;
    EXPECT_TRUE(expSe3(twist).translation.isApprox(Eigen::Vector3d(1.0, 2.0, 3.0), 1e-15));
}

TEST(RigidTransform, InverseUndoesTheTransform)
{
    CounterRandom random(2);
    const RigidTransform t = expSe3(randomTwist(random, 1.0));
    const Eigen::Vector3d point(12.0, -30.0, 400.0);
    EXPECT_LT((t.inverse() * (t * point) - point).norm(), 1e-10);
}

TEST(RigidTransform, AdjointMovesATwistThroughATransform)
{
    CounterRandom random(3);
    const RigidTransform t = expSe3(randomTwist(random, 0.7));
    const Vector6d x = 0.1 * randomTwist(random, 0.3);
    const RigidTransform left = t * expSe3(x) * t.inverse();
    const RigidTransform right = expSe3(adjoint(t) * x);
    EXPECT_LT((left.matrix() - right.matrix()).cwiseAbs().maxCoeff(), 1e-8);
}

TEST(RigidTransform, InverseRightJacobianMatchesFiniteDifferences)
{
    CounterRandom random(4);
    for (const double angle : {1e-3, 5e-3, 0.02, 0.4, 1.5}) {
        const Vector6d x = randomTwist(random, angle);
        const Matrix6d analytic = inverseRightJacobianSe3(x);
        for (int k = 0; k < 6; ++k) {
            Vector6d step = Vector6d::Zero();
            step(k) = 1e-6;
            const Vector6d ahead = logSe3(expSe3(x) * expSe3(step));
            const Vector6d behind = logSe3(expSe3(x) * expSe3(-step));
            const Vector6d numeric = (ahead - behind) / 2e-6;
            EXPECT_LT((numeric - analytic.col(k)).norm(), 2e-6 * (1.0 + analytic.col(k).norm())) << angle << " " << k;
        }
    }
}

TEST(RigidTransform, NearestRotationRepairsRoundedMatrices)
{
    CounterRandom random(5);
    const Eigen::Matrix3d exact = expSo3(randomTwist(random, 1.2).head<3>());
    Eigen::Matrix3d rounded = (exact * 1e6).array().round().matrix() / 1e6;
    const Eigen::Matrix3d repaired = nearestRotation(rounded);
    EXPECT_LT((repaired * repaired.transpose() - Eigen::Matrix3d::Identity()).norm(), 1e-14);
    EXPECT_LT(angleBetween(repaired, exact), 1e-5);
    EXPECT_NEAR(repaired.determinant(), 1.0, 1e-14);
}

TEST(RigidTransform, ReflectionsAndNaNAreNotRigid)
{
    RigidTransform mirror;
    mirror.rotation(0, 0) = -1.0;
    EXPECT_FALSE(isRigid(mirror));
    RigidTransform nan;
    nan.translation.x() = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(isRigid(nan));
    EXPECT_TRUE(isRigid(RigidTransform{}));
}

}   // namespace
