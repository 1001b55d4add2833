#include "core/registration/pose/tree_shift.h"

#include "core/registration/problem/registration_problem.h"
#include "core/registration/registration.h"
#include "tests/support/clean_case.h"

#include <gtest/gtest.h>
#include <cmath>

namespace angiopose::core {
namespace {

double rmsOneByOneMm(const std::vector<Eigen::Vector3d>& points, const RigidTransform& a, const RigidTransform& b)
{
    double sum = 0.0;
    for (const Eigen::Vector3d& point : points) {
        sum += (b * point - a * point).squaredNorm();
    }
    return std::sqrt(sum / static_cast<double>(points.size()));
}

TEST(TreeShift, AgreesWithMovingEveryPoint)
{
    CounterRandom random(7);
    std::vector<Eigen::Vector3d> points;
    for (int i = 0; i < 50; ++i) {
        points.emplace_back(40.0 + 20.0 * random.normal(), -90.0 + 5.0 * random.normal(), 11.0 * random.normal());
    }
    const TreeShift shift(points);
    const RigidTransform a{expSo3({0.4, -0.1, 2.9}), {3.0, -20.0, 740.0}};
    const RigidTransform b{expSo3({0.1, 0.7, -2.5}), {-8.0, 4.0, 760.0}};
    EXPECT_NEAR(shift.rmsMm(a, b), rmsOneByOneMm(points, a, b), 1e-9);
    const RigidTransform near{expSo3({1e-6, 0.0, 0.0}) * a.rotation, a.translation + Eigen::Vector3d(0.0, 1e-5, 0.0)};
    EXPECT_NEAR(shift.rmsMm(a, near), rmsOneByOneMm(points, a, near), 1e-9);
    EXPECT_DOUBLE_EQ(shift.rmsMm(a, a), 0.0);
}

TEST(TreeShift, OfTheReportsLeadsFromTheStartToTheResult)
{
    const test::CleanCase clean(3);
    const RegistrationInput input = clean.fromNearby(3);
    const auto result = registerVessels(input);
    ASSERT_TRUE(result);
    const RegistrationProblem problem = makeProblem(input, {}).value();
    RigidTransform last = problem.start;
    double farthestMm = 0.0;
    for (const IterationReport& report : result.value().history) {
        EXPECT_NEAR(report.stepMm, rmsOneByOneMm(problem.tree.points, last, report.cameraFromPatient), 1e-6);
        last = report.cameraFromPatient;
        farthestMm = std::max(farthestMm, report.stepMm);
    }
    EXPECT_GT(farthestMm, 0.1) << "the start lies off the truth";
    EXPECT_LT(result.value().history.back().stepMm, farthestMm);
}

}   // namespace
}   // namespace angiopose::core
