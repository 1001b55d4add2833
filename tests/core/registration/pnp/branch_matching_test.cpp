#include "core/registration/pnp/branch_matching.h"

#include "core/registration/pnp/pair_deformation.h"
#include "tests/support/clean_case.h"

#include <gtest/gtest.h>
#include <algorithm>

using namespace angiopose;

namespace {

using namespace core;

struct BranchMatchingTest : testing::Test {
    /// Share of the edges that are assigned to the curve of their own branch.
    double rightShare(const CentroidPose& pose, double reachPx) const
    {
        const std::vector<int> matched = matching.match(pose, reachPx);
        double right = 0.0;
        for (std::size_t e = 0; e < matched.size(); ++e) {
            right += matched[e] == matching.tree().edges[e].curve ? 1.0 : 0.0;
        }
        return right / static_cast<double>(matched.size());
    }

    test::CleanCase clean{2};
    RegistrationProblem problem = makeProblem(clean.from(clean.truth), {}).value();
    CentroidPose truth = aboutCentroid(clean.truth, problem.tree.centroid);
    BranchMatcher matching{problem};
};

TEST_F(BranchMatchingTest, GivesBranchesTheirOwnCurves)
{
    EXPECT_GT(rightShare(truth, 5.0), 0.9);
    Vector6d offset;
    offset << 0.01, -0.01, 0.02, 3.0, -2.0, 0.0;
    EXPECT_GT(rightShare(retract(truth, offset), 15.0), 0.75);
}

TEST_F(BranchMatchingTest, PairsAtTheTruthLieOnEachOther)
{
    const std::vector<BranchPair> pairs = matching.pairs(truth, 5.0);
    EXPECT_GT(pairs.size(), problem.tree.size() / 2);
    double sum = 0.0;
    for (const BranchPair& pair : pairs) {
        sum += (*project(problem.camera, clean.truth * problem.tree.points[pair.point]) - pair.pixel).norm();
    }
    EXPECT_LT(sum / static_cast<double>(pairs.size()), 1.0);
}

TEST_F(BranchMatchingTest, MatchesNothingFarAway)
{
    Vector6d far = Vector6d::Zero();
    far(3) = 600.0;
    const std::vector<int> matched = matching.match(retract(truth, far), 20.0);
    EXPECT_EQ(std::ranges::count(matched, BranchMatcher::noCurve), std::ssize(matched));
    EXPECT_TRUE(matching.pairs(retract(truth, far), 20.0).empty());
}

std::vector<Eigen::Vector3d> run(const Eigen::Vector3d& from, const Eigen::Vector3d& to)
{
    std::vector<Eigen::Vector3d> points;
    for (int k = 0; k <= 80; ++k) {
        points.push_back(from + k / 80.0 * (to - from));
    }
    return points;
}

/// A trunk and one side branch, in a frontal view.
struct TwoBranches {
    TwoBranches()
    {
        tree.branches = {{1, "", run({-20, 0, 0}, {20, 0, 0}), {}}, {2, "", run({0, 0, 0}, {0, -60, 0}), {}}};
        pose.translation = Eigen::Vector3d(0.0, 0.0, 800.0);
        target = projectTree(tree, camera, pose);
    }

    RegistrationProblem problem() const { return makeProblem({tree, target, camera, pose, {}, {}}, {}).value(); }

    ProjectionCamera camera{1877.0, 1877.0, 511.5, 511.5, 1024, 1024};
    VesselTree tree;
    RigidTransform pose;
    Centerline2d target;
};

/// The branch's own curve shifted by 6 px, plus an unrelated vessel at 2 px that does not leave the trunk.
Centerline2d withNearerStranger(const Centerline2d& seen)
{
    Centerline2d target = seen;
    Curve2d stranger = seen.curves[1];
    stranger.id = 7;
    for (Eigen::Vector2d& point : stranger.pointsPx) {
        point.x() -= 2.0;
    }
    stranger.pointsPx.erase(stranger.pointsPx.begin(), stranger.pointsPx.begin() + 8);
    for (Eigen::Vector2d& point : target.curves[1].pointsPx) {
        point.x() += 6.0;
    }
    target.curves.push_back(stranger);
    return target;
}

TEST(BranchMatcher, WhatMeetsInTheTreeMeetsInTheImage)
{
    TwoBranches two;
    two.target = withNearerStranger(two.target);
    const RegistrationProblem problem = two.problem();
    const BranchMatcher matching(problem);
    ASSERT_EQ(matching.tree().edges.size(), 3U);
    EXPECT_EQ(matching.match(aboutCentroid(two.pose, problem.tree.centroid), 10.0), (std::vector<int>{0, 0, 1}));
}

TEST(BranchMatcher, NearnessDecidesWhereNothingMeets)
{
    TwoBranches two;
    two.target = withNearerStranger(two.target);
    two.target.curves.erase(two.target.curves.begin());   // the trunk is not visible
    const RegistrationProblem problem = two.problem();
    const BranchMatcher matching(problem);
    const int none = BranchMatcher::noCurve;
    EXPECT_EQ(matching.match(aboutCentroid(two.pose, problem.tree.centroid), 10.0), (std::vector<int>{none, none, 1}));
}

TEST(BranchMatcher, ABranchAloneHasItsCurve)
{
    TwoBranches two;
    two.tree.branches.resize(1);
    two.target.curves.resize(1);
    const RegistrationProblem problem = two.problem();
    const BranchMatcher matching(problem);
    EXPECT_EQ(matching.match(aboutCentroid(two.pose, problem.tree.centroid), 10.0), (std::vector<int>{0}));
}

const std::function<bool()> neverStopped = [] { return false; };

TEST(PairDeformation, LeavesVesselsThatLieOnTheirPartners)
{
    const TwoBranches two;
    const RegistrationProblem problem = two.problem();
    const BranchMatcher matching(problem);
    const CentroidPose pose = aboutCentroid(two.pose, problem.tree.centroid);
    std::vector<BranchPair> pairs;
    for (std::size_t i = 0; i < problem.tree.size(); ++i) {
        pairs.push_back({i, *project(problem.camera, two.pose * problem.tree.points[i])});
    }
    const PairDeformation deformation = deformOntoPairs(problem, matching.tree(), pose, pairs, neverStopped);
    EXPECT_LT(deformation.maxMotionMm, 1e-9);
    EXPECT_EQ(deformOntoPairs(problem, matching.tree(), pose, {}, neverStopped).maxMotionMm, 0.0);
}

// A branch of 60 mm swings about its root by 10°: the motion across the rays is recovered and lengths are preserved.
TEST(PairDeformation, FollowsAVesselThatSwingsAndKeepsItsLength)
{
    const TwoBranches two;
    const RegistrationProblem problem = two.problem();
    const BranchMatcher matching(problem);
    const CentroidPose pose = aboutCentroid(two.pose, problem.tree.centroid);
    const Eigen::Matrix3d swing = expSo3(Eigen::Vector3d(0.0, 0.0, 0.1745));
    std::vector<BranchPair> pairs;
    std::vector<Eigen::Vector3d> known;
    for (std::size_t i = 0; i < problem.tree.size(); ++i) {
        const Eigen::Vector3d& point = problem.tree.points[i];
        const double share = problem.tree.branchIndex[i] == 1 ? 1.0 : 0.0;
        known.emplace_back(share * (swing * point - point));
        pairs.push_back({i, *project(problem.camera, two.pose * (point + known.back()))});
    }
    const PairDeformation deformation = deformOntoPairs(problem, matching.tree(), pose, pairs, neverStopped);
    EXPECT_GT(deformation.maxMotionMm, 9.0);
    EXPECT_LT(deformation.medianPx, 0.2);
    EXPECT_GT(deformation.medianBeforePx, deformation.medianPx);
    for (std::size_t i = 0; i < known.size(); ++i) {
        EXPECT_LT((deformation.motionMm[i] - known[i]).norm(), 0.5) << i;
        if (i > 0 && problem.tree.branchIndex[i] == problem.tree.branchIndex[i - 1]) {
            const Eigen::Vector3d before = problem.tree.points[i] - problem.tree.points[i - 1];
            const Eigen::Vector3d after = before + deformation.motionMm[i] - deformation.motionMm[i - 1];
            EXPECT_NEAR(after.norm() / before.norm(), 1.0, 0.1) << i;
        }
    }
}

TEST(PairDeformation, EndsWhenStopped)
{
    const TwoBranches two;
    const RegistrationProblem problem = two.problem();
    const BranchMatcher matching(problem);
    const CentroidPose pose = aboutCentroid(two.pose, problem.tree.centroid);
    std::vector<BranchPair> pairs;
    for (std::size_t i = 0; i < problem.tree.size(); ++i) {
        pairs.push_back({i, *project(problem.camera, two.pose * problem.tree.points[i]) + Eigen::Vector2d(9.0, 0.0)});
    }
    int asked = 0;
    deformOntoPairs(problem, matching.tree(), pose, pairs, [&] { return ++asked == 3; });
    EXPECT_EQ(asked, 3);
}

}   // namespace
