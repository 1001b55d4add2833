#include "core/registration/alignment/pose_search.h"

#include "core/registration/alignment/pose_ranking.h"
#include "tests/support/clean_case.h"

#include "core/geometry/angle_units.h"

#include <gtest/gtest.h>

namespace angiopose::core {
namespace {

struct PoseSearchTest : ::testing::Test {
    /// Distance to the truth of the coarse pose found from an initial pose that is off by `step`.
    Vector6d errorAfterWideSearch(const Vector6d& step)
    {
        const CentroidPose start = retract(truth, step);
        const InitialPosePrior prior = initialPosePrior(start, options);
        PoseRanking ranking(problem, target, prior);
        const PoseSearch search(problem, target, options);
        for (const CentroidPose& hypothesis :
             search.searchWide(start, [](double) { return ObserverDecision::Continue; })) {
            ranking.add(hypothesis);
        }
        return stepBetween(truth, ranking.best().pose);
    }

    RegistrationOptions options;
    test::CleanCase clean{2};
    RegistrationProblem problem = makeProblem(clean.from(clean.truth), options).value();
    TargetLines target{problem.target, problem.camera};
    CentroidPose truth = aboutCentroid(clean.truth, problem.tree.centroid);
};

TEST_F(PoseSearchTest, FindsStartsThatAreFarOffInEveryDirection)
{
    CounterRandom random(9);
    for (int trial = 0; trial < 4; ++trial) {
        Vector6d step;
        for (double& value : step) {
            value = random.normal();
        }
        step.head<3>() *= 15.0 * radiansPerDegree / step.head<3>().norm();
        step.tail<3>() *= 60.0 / step.tail<3>().norm();
        const Vector6d error = errorAfterWideSearch(step);
        EXPECT_LT(error.head<3>().norm(), 0.5 * radiansPerDegree);
        EXPECT_LT(error.segment<2>(3).norm(), 1.0);
    }
}

TEST_F(PoseSearchTest, JunctionsFindStartsTurnedAndDisplacedFar)
{
    CounterRandom random(4);
    for (int trial = 0; trial < 3; ++trial) {
        Vector6d step;
        for (double& value : step) {
            value = random.normal();
        }
        step.head<3>() *= 60.0 * radiansPerDegree / step.head<3>().norm();
        step.tail<3>() *= 100.0 / step.tail<3>().norm();
        const CentroidPose start = retract(truth, step);
        PoseRanking ranking(problem, target, initialPosePrior(start, options));
        const PoseSearch search(problem, target, options);
        for (const CentroidPose& hypothesis :
             search.searchByJunctions(start, [](double) { return ObserverDecision::Continue; })) {
            ranking.add(hypothesis);
        }
        const Vector6d error = stepBetween(truth, ranking.best().pose);
        EXPECT_LT(error.head<3>().norm(), 0.5 * radiansPerDegree);
        EXPECT_LT(error.segment<2>(3).norm(), 1.0);
    }
}

TEST_F(PoseSearchTest, JunctionsKeepWhatIsLockedAndWithinReach)
{
    options.locks[static_cast<std::size_t>(PoseAxis::Roll)] = true;
    options.angiopose.searchRadiusMm = 50.0;
    options.angiopose.searchTiltDeg = 20.0;
    problem = makeProblem(clean.from(clean.truth), options).value();
    const PoseSearch search(problem, target, options);
    const auto found = search.searchByJunctions(truth, [](double) { return ObserverDecision::Continue; });
    EXPECT_FALSE(found.empty());
    for (const CentroidPose& pose : found) {
        EXPECT_LT((pose.centroidInCamera - truth.centroidInCamera).head<2>().norm(), 50.0);
        EXPECT_NEAR(problem.freedom.coordinates(pose)[2], problem.freedom.coordinates(truth)[2], 1e-9);
    }
}

TEST_F(PoseSearchTest, JunctionsAreNotNeeded)
{
    const int branch = problem.tree.branchIndex.front();
    VesselTree alone;
    alone.branches = {clean.tree.branches[static_cast<std::size_t>(branch)]};
    RegistrationInput input = clean.from(clean.truth);
    input.tree = alone;
    problem = makeProblem(input, options).value();
    EXPECT_TRUE(PoseSearch(problem, target, options)
                    .searchByJunctions(truth, [](double) { return ObserverDecision::Continue; })
                    .empty());
}

TEST_F(PoseSearchTest, RecentringMeetsTheTracedVessels)
{
    Vector6d step = Vector6d::Zero();
    step[3] = 300.0;
    const PoseSearch search(problem, target, options);
    const Vector6d error = stepBetween(truth, search.recenterPose(retract(truth, step)));
    EXPECT_LT(error.segment<2>(3).norm(), 15.0);
}

TEST_F(PoseSearchTest, RanksTheTruthAboveAllElse)
{
    PoseRanking ranking(problem, target, initialPosePrior(truth, options));
    Vector6d aside = Vector6d::Zero();
    aside[3] = 40.0;
    ranking.add(retract(truth, aside));
    EXPECT_FALSE(ranking.isConclusive());
    ranking.add(truth);
    ranking.add(retract(truth, -aside));
    EXPECT_TRUE(ranking.isConclusive());
    EXPECT_LT(stepBetween(truth, ranking.best().pose).tail<3>().norm(), 1.0);
    EXPECT_EQ(ranking.distinctPoses(1.0, 3).size(), 1u);
}

}   // namespace
}   // namespace angiopose::core
