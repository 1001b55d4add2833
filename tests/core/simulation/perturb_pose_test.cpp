#include "core/simulation/simulated_case.h"

#include <gtest/gtest.h>
#include <numbers>

using namespace angiopose;

namespace {

using namespace core;

const Eigen::Vector3d centroid(12.0, -7.0, 30.0);

RigidTransform somePose()
{
    const Eigen::Matrix3d rotation = expSo3({0.3, -0.8, 0.2});
    return {rotation, Eigen::Vector3d(3.0, -5.0, 800.0) - rotation * centroid};
}

struct Spread {
    Eigen::Vector3d rotationDeg = Eigen::Vector3d::Zero();   ///< RMS per camera axis
    Eigen::Vector3d centroidMm = Eigen::Vector3d::Zero();   ///< RMS per camera axis
};

template <class Perturb>
Spread spreadOf(Perturb perturb)
{
    constexpr int draws = 4000;
    CounterRandom random(11);
    Spread sum;
    for (int i = 0; i < draws; ++i) {
        const RigidTransform pose = perturb(random);
        const Eigen::Vector3d omega = logSo3(pose.rotation * somePose().rotation.transpose());
        sum.rotationDeg += (omega * 180.0 / std::numbers::pi).cwiseAbs2();
        sum.centroidMm += (pose * centroid - somePose() * centroid).cwiseAbs2();
    }
    return {(sum.rotationDeg / draws).cwiseSqrt(), (sum.centroidMm / draws).cwiseSqrt()};
}

TEST(PerturbPose, AboutCentroidKeepsRotationAndShiftApart)
{
    const Spread both =
        spreadOf([](CounterRandom& random) { return perturbAboutCentroid(somePose(), centroid, 2.0, 5.0, random); });
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_NEAR(both.rotationDeg[axis], 2.0, 0.1);
        EXPECT_NEAR(both.centroidMm[axis], 5.0, 0.25);
    }
    const Spread turned =
        spreadOf([](CounterRandom& random) { return perturbAboutCentroid(somePose(), centroid, 2.0, 0.0, random); });
    EXPECT_LT(turned.centroidMm.maxCoeff(), 1e-9);
}

TEST(PerturbPose, AboutSourceSwingsTheCentroidSideways)
{
    const Spread spread =
        spreadOf([](CounterRandom& random) { return perturbAboutSource(somePose(), 2.0, 5.0, random); });
    const double swingMm = 800.0 * 2.0 * std::numbers::pi / 180.0;
    EXPECT_NEAR(spread.rotationDeg.x(), 2.0, 0.1);
    EXPECT_NEAR(spread.centroidMm.x(), std::hypot(swingMm, 5.0), 1.5);
    EXPECT_NEAR(spread.centroidMm.y(), std::hypot(swingMm, 5.0), 1.5);
    EXPECT_NEAR(spread.centroidMm.z(), 5.0, 1.0);
}

TEST(PerturbPose, StaysRigidAndRepeats)
{
    CounterRandom first(4);
    CounterRandom second(4);
    const RigidTransform a = perturbAboutSource(somePose(), 5.0, 10.0, first);
    const RigidTransform b = perturbAboutSource(somePose(), 5.0, 10.0, second);
    EXPECT_TRUE(isRigid(a, 1e-12));
    EXPECT_EQ(a.matrix(), b.matrix());
}

TEST(PerturbPose, UniformlyStaysInsideItsRangeAndFillsIt)
{
    constexpr double rangeMm = 12.0;
    constexpr double rangeDeg = 3.0;
    CounterRandom random(5);
    Eigen::Vector3d farthest = Eigen::Vector3d::Zero();
    double largestDeg = 0.0;
    for (int i = 0; i < 500; ++i) {
        const RigidTransform moved = displaceUniformly(somePose(), centroid, rangeDeg, rangeMm, random);
        const Eigen::Vector3d shift = moved * centroid - somePose() * centroid;
        farthest = farthest.cwiseMax(shift.cwiseAbs());
        largestDeg = std::max(largestDeg, angleBetween(moved.rotation, somePose().rotation) * 180.0 / std::numbers::pi);
        ASSERT_TRUE(isRigid(moved, 1e-12));
    }
    EXPECT_LE(farthest.maxCoeff(), rangeMm);
    EXPECT_GT(farthest.minCoeff(), 0.95 * rangeMm);
    EXPECT_LE(largestDeg, rangeDeg * std::numbers::sqrt3);
    EXPECT_GT(largestDeg, rangeDeg);
}

}   // namespace
