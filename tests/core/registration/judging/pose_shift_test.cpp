#include "core/registration/judging/pose_shift.h"

#include "core/registration/pose/centroid_pose.h"
#include "tests/support/clean_case.h"

#include <gtest/gtest.h>
#include <cmath>

namespace angiopose::core {
namespace {

struct PoseShiftTest : ::testing::Test {
    test::CleanCase clean{2};
    RegistrationOptions options;
    RegistrationProblem problem = makeProblem(clean.from(clean.truth), options).value();
    TargetLines target{problem.target, problem.camera};

    RigidTransform truthMovedBy(const Vector6d& step) const
    {
        const Eigen::Vector3d& centroid = problem.wholeTreeCentroid;
        return cameraFromPatient(retract(aboutCentroid(clean.truth, centroid), step), centroid);
    }
};

TEST_F(PoseShiftTest, IsBlindToDepthAndCountsTheRest)
{
    Vector6d step = Vector6d::Zero();
    step[5] = 7.0;
    EXPECT_LT(meanShiftMm(problem.tree, clean.truth, truthMovedBy(step)), 1e-9);
    step[3] = 3.0;
    step[4] = -4.0;
    EXPECT_NEAR(meanShiftMm(problem.tree, clean.truth, truthMovedBy(step)), 5.0, 1e-9);
}

TEST_F(PoseShiftTest, ExpectationIsTheSpreadOfDrawnPoses)
{
    PoseUncertainty uncertainty;
    Vector6d std;
    std << 0.01, 0.02, 0.03, 0.5, 0.8, 10.0;
    uncertainty.imageCovariance.diagonal() = std.cwiseAbs2();
    CounterRandom random(3);
    double squares = 0.0;
    constexpr int draws = 400;
    for (int draw = 0; draw < draws; ++draw) {
        Vector6d step;
        for (double& value : step) {
            value = random.normal();
        }
        const RigidTransform pose = truthMovedBy(step.cwiseProduct(std));
        for (const Eigen::Vector3d& point : problem.tree.points) {
            squares += (pose * point - clean.truth * point).head<2>().squaredNorm() /
                       static_cast<double>(draws * problem.tree.size());
        }
    }
    const double expected = expectedShiftMm(problem, clean.truth, uncertainty);
    EXPECT_NEAR(expected, std::sqrt(squares), 0.1 * expected);
}

TEST_F(PoseShiftTest, APoseBesideTheVesselsSettlesOnThem)
{
    EXPECT_LT(refinementShiftMm(problem, target, clean.truth, options), 0.05);
    Vector6d step = Vector6d::Zero();
    step[3] = 1.6;
    EXPECT_NEAR(refinementShiftMm(problem, target, truthMovedBy(step), options), 1.6, 0.1);
}

}   // namespace
}   // namespace angiopose::core
