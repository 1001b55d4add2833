#include "core/registration/pnp/oriented_mixture.h"

#include "core/registration/pnp/sparse_kernel.h"
#include "tests/support/clean_case.h"

#include <gtest/gtest.h>

using namespace angiopose;

namespace {

using namespace core;

struct OrientedMixtureTest : testing::Test {
    test::CleanCase clean{2};
    RegistrationProblem problem = makeProblem(clean.from(clean.truth), {}).value();
    CentroidPose truth = aboutCentroid(clean.truth, problem.tree.centroid);
};

TEST_F(OrientedMixtureTest, GradientMatchesDifferences)
{
    OrientedMixtureMetric mixture(problem, {6.0, 0.3, 1.0});
    Vector6d offset;
    offset << 0.01, -0.02, 0.015, 1.0, -2.0, 5.0;
    const CentroidPose pose = retract(truth, offset);
    Vector6d gradient;
    mixture.distance(pose, gradient);
    Vector6d unused;
    for (int k = 0; k < 6; ++k) {
        const double h = k < 3 ? 1e-6 : 1e-4;
        const double slope = (mixture.distance(retract(pose, h * Vector6d::Unit(k)), unused) -
                              mixture.distance(retract(pose, -h * Vector6d::Unit(k)), unused)) /
                             (2.0 * h);
        EXPECT_NEAR(gradient(k), slope, 2e-3 * gradient.cwiseAbs().maxCoeff()) << k;
    }
}

TEST_F(OrientedMixtureTest, IsLeastAtTheTruth)
{
    OrientedMixtureMetric mixture(problem, {3.0, 0.3, 1.0});
    Vector6d unused;
    const double atTruth = mixture.distance(truth, unused);
    for (int k = 0; k < 6; ++k) {
        for (const double side : {-1.0, 1.0}) {
            const double h = side * (k < 3 ? 0.02 : 4.0);
            EXPECT_GT(mixture.distance(retract(truth, h * Vector6d::Unit(k)), unused), atTruth) << k;
        }
    }
}

// The self term keeps a tree from shrinking onto one vessel (ALGORITHMS §3.12).
TEST_F(OrientedMixtureTest, TheSelfTermChargesCollapse)
{
    Vector6d unused;
    Vector6d away = Vector6d::Zero();
    away(5) = 2000.0;
    const CentroidPose collapsed = retract(truth, away);
    OrientedMixtureMetric with(problem, {15.0, 0.3, 1.0});
    OrientedMixtureMetric without(problem, {15.0, 0.3, 0.0});
    const double charged = with.distance(collapsed, unused) - with.distance(truth, unused);
    const double free = without.distance(collapsed, unused) - without.distance(truth, unused);
    EXPECT_GT(charged, free);
    EXPECT_GT(charged, 0.0);
}

TEST(BinGrid, VisitsEveryPointWithinACell)
{
    CounterRandom random(5);
    std::vector<Eigen::Vector2d> points;
    for (int i = 0; i < 400; ++i) {
        points.emplace_back(random.uniform(-50.0, 300.0), random.uniform(0.0, 90.0));
    }
    BinGrid grid;
    grid.fill(points, 7.0);
    for (int i = 0; i < 200; ++i) {
        const Eigen::Vector2d place(random.uniform(-90.0, 350.0), random.uniform(-30.0, 120.0));
        std::vector<int> visits(points.size(), 0);
        grid.visitNear(place, [&](std::size_t k) { ++visits[k]; });
        for (std::size_t k = 0; k < points.size(); ++k) {
            EXPECT_LE(visits[k], 1);
            if ((points[k] - place).norm() <= 7.0) {
                EXPECT_EQ(visits[k], 1);
            }
        }
    }
}

TEST(SparseKernel, InPlaneStepsLeaveTheOtherTurnsAlone)
{
    const test::CleanCase clean(3);
    const RegistrationProblem problem = makeProblem(clean.fromNearby(2), {}).value();
    SparseKernel kernel(problem, 200);
    const CentroidPose start = aboutCentroid(problem.start, problem.tree.centroid);
    const CentroidPose inPlane = kernel.gaussNewtonStep(start, 20.0, true);
    const Vector6d step = stepBetween(start, inPlane);
    EXPECT_LT(step.head<2>().norm(), 1e-12);
    EXPECT_GT(step.tail<3>().norm(), 0.1);
    CentroidPose free = start;
    for (int i = 0; i < 6; ++i) {
        free = kernel.gaussNewtonStep(free, 20.0, false);
    }
    EXPECT_GT(kernel.agreement(free, 6.0), kernel.agreement(start, 6.0));
}

}   // namespace
