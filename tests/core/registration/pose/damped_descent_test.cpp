#include "core/registration/pose/damped_descent.h"

#include "core/registration/pose/centroid_pose.h"

#include <gtest/gtest.h>

namespace angiopose::core {
namespace {

constexpr double treeSpreadMm = 40.0;

/// Least squares of atan(steepness · θ − wish) per parameter, where a full step from far away overshoots.
class Arctangents {
public:
    using State = Vector6d;
    using Step = Vector6d;
    struct Evaluation {
        double cost = 0.0;
    };
    using Equations = NormalEquations;

    explicit Arctangents(const Vector6d& request) : request_(request) {}

    bool evaluate(const Vector6d& state, Evaluation& evaluation)
    {
        ++evaluations;
        evaluation.cost = residual(state).squaredNorm();
        return state.cwiseAbs().maxCoeff() < limit;
    }
    NormalEquations equations(const Vector6d& state, const Evaluation&)
    {
        ++linearizations;
        const Vector6d slope = (1.0 + (state - request_).array().square()).inverse();
        NormalEquations equations;
        equations.hessian.diagonal() = slope.cwiseAbs2();
        equations.gradient = slope.cwiseProduct(residual(state));
        return equations;
    }
    Vector6d step(const Vector6d&, const NormalEquations& equations, double damping) const
    {
        return dampedStep(equations, damping);
    }
    Vector6d retract(const Vector6d& state, const Vector6d& step) const { return state + step; }
    std::optional<double> decrease(const Evaluation& here, const Evaluation& there) const
    {
        return there.cost <= here.cost ? std::optional(here.cost - there.cost) : std::nullopt;
    }
    double lengthMm(const Vector6d&, const Vector6d& step) const { return stepLengthMm(step, treeSpreadMm); }

    double limit = 1e9;
    int evaluations = 0;
    int linearizations = 0;

private:
    Vector6d residual(const Vector6d& state) const { return (state - request_).array().atan(); }

    Vector6d request_;
};

ObserverDecision goOn(const StepOutcome&)
{
    return ObserverDecision::Continue;
}

// Only the rotations are wrong and the first full step worsens them. Measured by its shift alone, the step would look
// converged.
TEST(DampedDescent, ARefusedTurnIsNotTakenForSettled)
{
    const Vector6d request = 2.5 * Vector6d::Unit(1);
    Arctangents problem(request);
    EvaluationPair<Arctangents::Evaluation> evaluations;
    DampedDescent descent(problem, Vector6d(Vector6d::Zero()), evaluations, {.minMotionMm = 1e-6});
    const StepOutcome first = descent.step();
    ASSERT_FALSE(first.isAccepted);
    EXPECT_FALSE(first.isConverged);
    EXPECT_TRUE(descent.descend(100, goOn).isConverged);
    EXPECT_LT((descent.state() - request).norm(), 1e-7);
}

TEST(DampedDescent, LinearizesOncePerPlaceHoweverManyTriesItTakes)
{
    Arctangents problem(2.5 * Vector6d::Unit(1));
    EvaluationPair<Arctangents::Evaluation> evaluations;
    DampedDescent descent(problem, Vector6d(Vector6d::Zero()), evaluations, {20, 1e-6});
    EXPECT_TRUE(descent.step().isAccepted);
    EXPECT_EQ(problem.linearizations, 1);
    EXPECT_GT(problem.evaluations, 2);
}

TEST(DampedDescent, AStepThatPromisesLittleSettlesIt)
{
    const Vector6d request = 0.5 * Vector6d::Ones();
    const auto stepsUntil = [&](double minGain) {
        Arctangents problem(request);
        EvaluationPair<Arctangents::Evaluation> evaluations;
        DampedDescent descent(problem, Vector6d(Vector6d::Zero()), evaluations,
                              {.minMotionMm = 1e-9, .minGain = minGain});
        int steps = 0;
        const StepOutcome last = descent.descend(50, [&](const StepOutcome&) {
            ++steps;
            return ObserverDecision::Continue;
        });
        EXPECT_TRUE(last.isConverged);
        EXPECT_LT((descent.state() - request).norm(), 1e-3);
        return steps;
    };
    EXPECT_LT(stepsUntil(1e-4), stepsUntil(0.0));
}

TEST(DampedDescent, NeverStandsWhereItCannot)
{
    Arctangents problem(0.9 * Vector6d::Ones());
    problem.limit = 0.5;
    EvaluationPair<Arctangents::Evaluation> evaluations;
    DampedDescent descent(problem, Vector6d(Vector6d::Zero()), evaluations, {.minMotionMm = 1e-6});
    ASSERT_TRUE(descent.isFeasible());
    descent.descend(60, goOn);
    EXPECT_LT(descent.state().maxCoeff(), 0.5);
    EXPECT_GT(descent.state().minCoeff(), 0.4);
    EXPECT_FALSE(DampedDescent(problem, Vector6d(Vector6d::Ones()), evaluations, {}).isFeasible());
}

TEST(DampedDescent, AStopEndsItAfterTheStep)
{
    Arctangents problem(0.9 * Vector6d::Ones());
    EvaluationPair<Arctangents::Evaluation> evaluations;
    DampedDescent descent(problem, Vector6d(Vector6d::Zero()), evaluations, {});
    int steps = 0;
    const StepOutcome last = descent.descend(
        50, [&](const StepOutcome&) { return ++steps == 2 ? ObserverDecision::Stop : ObserverDecision::Continue; });
    EXPECT_TRUE(last.isStopped);
    EXPECT_EQ(steps, 2);
}

}   // namespace
}   // namespace angiopose::core
