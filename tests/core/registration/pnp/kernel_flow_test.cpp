#include "core/registration/pnp/kernel_flow.h"

#include "tests/support/clean_case.h"

#include <gtest/gtest.h>

using namespace angiopose;

namespace {

using namespace core;

struct KernelFlowTest : testing::Test {
    KernelFlowTest() { offset << 0.01, -0.02, 0.015, 1.0, -2.0, 5.0; }

    test::CleanCase clean{2};
    RegistrationProblem problem = makeProblem(clean.from(clean.truth), {}).value();
    CentroidPose truth = aboutCentroid(clean.truth, problem.tree.centroid);
    Vector6d offset;
};

// The gradient treats the labels as constant; without directions they do not change. The steps are wide enough that
// pairs entering and leaving the kernel support cancel out.
TEST_F(KernelFlowTest, GradientMatchesDifferences)
{
    KernelFlow flow(problem, {8.0, false});
    const CentroidPose pose = retract(truth, offset);
    const Vector6d gradient = flow.at(pose).gradient;
    for (int k = 0; k < 6; ++k) {
        const double h = k < 3 ? 1e-4 : 1e-2;
        const double slope = (flow.at(retract(pose, h * Vector6d::Unit(k))).value -
                              flow.at(retract(pose, -h * Vector6d::Unit(k))).value) /
                             (2.0 * h);
        EXPECT_NEAR(gradient(k), slope, 5e-3 * gradient.cwiseAbs().maxCoeff()) << k;
    }
}

TEST_F(KernelFlowTest, IsHighestAtTheTruth)
{
    KernelFlow flow(problem, {3.0, true});
    const double atTruth = flow.at(truth).value;
    for (int k = 0; k < 6; ++k) {
        for (const double side : {-1.0, 1.0}) {
            const double h = side * (k < 3 ? 0.02 : 8.0);
            EXPECT_LT(flow.at(retract(truth, h * Vector6d::Unit(k))).value, atTruth) << k;
        }
    }
}

TEST_F(KernelFlowTest, TheSeriesFollowsTheFlowAlongAStep)
{
    KernelFlow flow(problem, {20.0, false});
    const CentroidPose pose = retract(truth, offset);
    Vector6d step;
    step << 0.002, 0.003, -0.004, 0.8, 0.5, 3.0;   // a few px
    const KernelFlow::ValueAndGradient here = flow.at(pose);
    const PowerSeries series = flow.along(step);
    EXPECT_NEAR(series.value(0.0), here.value, 1e-12);
    EXPECT_NEAR(series.slope(0.0), here.gradient.dot(step), 1e-9 * std::abs(here.value));
    const double change = flow.at(retract(pose, step)).value - here.value;
    EXPECT_GT(std::abs(change), 1e-3 * here.value);
    EXPECT_NEAR(series.value(1.0) - here.value, change, 0.02 * std::abs(change));
}

TEST_F(KernelFlowTest, DirectionsTakeFromPairsThatCross)
{
    KernelFlow with(problem, {20.0, true});
    KernelFlow without(problem, {20.0, false});
    EXPECT_LT(with.at(truth).value, 0.99 * without.at(truth).value);
}

}   // namespace
