#include "core/registration/pose/damped_step.h"

#include "core/support/random.h"

#include <gtest/gtest.h>

using namespace angiopose;

namespace {

using namespace core;

/// Σ JᵀJ and Σ Jᵀr of random rows whose rotation columns are `scale` times larger, as with raw radians.
NormalEquations randomEquations(double scale)
{
    CounterRandom random(21);
    NormalEquations equations;
    for (int i = 0; i < 30; ++i) {
        Vector6d row;
        for (int k = 0; k < 6; ++k) {
            row(k) = (k < 3 ? scale : 1.0) * random.normal();
        }
        equations.hessian += row * row.transpose();
        equations.gradient += row * random.normal();
    }
    return equations;
}

TEST(DampedStep, WithoutDampingSolvesTheNormalEquations)
{
    const NormalEquations equations = randomEquations(800.0);
    const Vector6d step = dampedStep(equations, 0.0);
    EXPECT_LT((equations.hessian * step + equations.gradient).norm(), 1e-10 * equations.gradient.norm());
    EXPECT_GT(predictedDecrease(equations, step), 0.0);
}

TEST(DampedStep, DoesNotDependOnTheUnitsOfTheParameters)
{
    const Vector6d small = dampedStep(randomEquations(1.0), 0.3);
    const Vector6d large = dampedStep(randomEquations(800.0), 0.3);
    EXPECT_LT((800.0 * large.head<3>() - small.head<3>()).norm(), 1e-12);
    EXPECT_LT((large.tail<3>() - small.tail<3>()).norm(), 1e-12);
}

TEST(DampedStep, RotationFreedomLeavesTheShiftAlone)
{
    const NormalEquations equations = randomEquations(1.0);
    const Vector6d step = dampedStep(equations, 0.0, Freedom::Rotation);
    EXPECT_EQ(step.tail<3>().norm(), 0.0);
    const Eigen::Vector3d rest =
        equations.hessian.topLeftCorner<3, 3>() * step.head<3>() + equations.gradient.head<3>();
    EXPECT_LT(rest.norm(), 1e-12 * equations.gradient.norm());
}

TEST(DampedStep, LeavesParametersWithoutDataAtZero)
{
    NormalEquations equations = randomEquations(1.0);
    equations.hessian.row(5).setZero();
    equations.hessian.col(5).setZero();
    equations.gradient(5) = 0.0;
    const Vector6d step = dampedStep(equations, 1e-3);
    EXPECT_TRUE(step.allFinite());
    EXPECT_EQ(step(5), 0.0);
}

TEST(DampedStep, ReadsOnlyTheLowerTriangle)
{
    NormalEquations equations = randomEquations(1.0);
    const Vector6d step = dampedStep(equations, 0.1);
    equations.hessian.triangularView<Eigen::StrictlyUpper>().setConstant(99.0);
    EXPECT_EQ(dampedStep(equations, 0.1), step);
}

TEST(Damping, RelaxesAfterGoodStepsAndGrowsFasterWithEachRejection)
{
    Damping damping;
    damping.accept(1.0);
    EXPECT_DOUBLE_EQ(damping.factor(), 1e-3 / 3.0);
    damping.reject();
    damping.reject();
    EXPECT_DOUBLE_EQ(damping.factor(), 8e-3 / 3.0);
    damping.accept(0.0);
    EXPECT_DOUBLE_EQ(damping.factor(), 16e-3 / 3.0);
}

}   // namespace
