#include "core/registration/pose/minimize.h"

#include "core/registration/pose/evolution.h"
#include "core/registration/pose/pose_parameters.h"
#include "core/support/random.h"

#include <gtest/gtest.h>
#include <cmath>

using namespace angiopose;

namespace {

using namespace core;

/// Rosenbrock function: a long curved valley with its minimum at (1, 1).
double rosenbrock(const Eigen::VectorXd& x, Eigen::VectorXd& gradient)
{
    const double a = 1.0 - x(0);
    const double b = x(1) - x(0) * x(0);
    if (gradient.size() == 2) {
        gradient << -2.0 * a - 400.0 * x(0) * b, 200.0 * b;
    }
    return a * a + 100.0 * b * b;
}

TEST(Minimize, EveryMinimizerFindsTheEndOfTheValley)
{
    for (const Minimizer minimizer : {Minimizer::NelderMead, Minimizer::Powell, Minimizer::Lbfgs}) {
        MinimizeOptions options;
        options.minimizer = minimizer;
        options.tolerance = 1e-7;
        options.maxEvaluations = 2000;
        const Minimum minimum = minimize(rosenbrock, Eigen::Vector2d(-1.2, 1.0), options, [] { return false; });
        EXPECT_LT((minimum.x - Eigen::Vector2d::Ones()).norm(), 1e-3) << static_cast<int>(minimizer);
    }
}

TEST(Minimize, StopsWhenToldAndKeepsTheBest)
{
    for (const Minimizer minimizer : {Minimizer::NelderMead, Minimizer::Powell, Minimizer::Lbfgs}) {
        MinimizeOptions options;
        options.minimizer = minimizer;
        options.tolerance = 1e-9;
        int evaluations = 0;
        double least = 1e300;
        const auto cost = [&](const Eigen::VectorXd& x, Eigen::VectorXd& gradient) {
            ++evaluations;
            const double value = rosenbrock(x, gradient);
            least = std::min(least, value);
            return value;
        };
        const Minimum minimum = minimize(cost, Eigen::Vector2d(-1.2, 1.0), options, [&] { return evaluations >= 7; });
        EXPECT_EQ(evaluations, 7);
        EXPECT_FALSE(minimum.isConverged);
        EXPECT_DOUBLE_EQ(minimum.cost, least);
    }
}

TEST(Evolution, BothStrategiesFindTheMinimumOfANarrowValley)
{
    const Eigen::VectorXd goal = Eigen::VectorXd::LinSpaced(6, -1.0, 1.5);
    for (const auto evolve : {minimizeCmaEs, minimizeOnePlusOneEs}) {
        double least = 1e300;
        const auto cost = [&](const Eigen::VectorXd& x) {
            double sum = 0.0;
            for (Eigen::Index i = 0; i < 6; ++i) {
                sum += std::pow(10.0, 0.4 * static_cast<double>(i)) * std::pow(x(i) - goal(i), 2);
            }
            least = std::min(least, sum);
            return sum;
        };
        evolve(cost, 6, {16, 6000, 1e-6, 3}, [] { return false; });
        EXPECT_LT(least, 1e-3);
    }
}

TEST(Evolution, CovarianceAdaptationNarrowsWithinItsBudget)
{
    int evaluations = 0;
    const auto cost = [&](const Eigen::VectorXd& x) {
        ++evaluations;
        return x.squaredNorm();
    };
    EXPECT_TRUE(minimizeCmaEs(cost, 6, {16, 6000, 1e-4, 1}, [] { return false; }));
    EXPECT_LT(evaluations, 3000);
    evaluations = 0;
    EXPECT_FALSE(minimizeCmaEs(cost, 6, {16, 100, 1e-4, 1}, [] { return false; }));
    EXPECT_LE(evaluations, 100);
}

TEST(PoseParameters, GradientMatchesDifferences)
{
    CounterRandom random(7);
    const CentroidPose origin{expSo3(Eigen::Vector3d(0.3, -0.5, 0.9)), Eigen::Vector3d(5.0, -7.0, 800.0)};
    const PoseParameters parameters(origin, clinicalUnits(30.0, 40.0, 2.0, 10.0), {});
    const Eigen::Vector3d point(20.0, -30.0, 40.0);
    const Eigen::Vector3d pull(0.3, 0.8, -0.4);
    const auto cost = [&](const Vector6d& x) {
        const CentroidPose pose = parameters.pose(x);
        return pull.dot(pose.rotation * point + pose.centroidInCamera);
    };
    Vector6d x;
    for (double& value : x) {
        value = 0.5 * random.normal();
    }
    const CentroidPose pose = parameters.pose(x);
    Vector6d stepGradient;
    stepGradient << (pose.rotation * point).cross(pull), pull;
    const Vector6d gradient = parameters.gradient(x, stepGradient);
    for (int k = 0; k < 6; ++k) {
        const Vector6d step = 1e-6 * Vector6d::Unit(k);
        EXPECT_NEAR(gradient(k), (cost(x + step) - cost(x - step)) / 2e-6, 1e-5) << k;
    }
}

}   // namespace
