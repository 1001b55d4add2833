#include "core/registration/alignment/pose_search.h"

#include "core/registration/alignment/pose_ranking.h"
#include "tests/support/clean_case.h"

#include <gtest/gtest.h>
#include <numbers>

namespace core {
namespace {

constexpr double degree = std::numbers::pi / 180.0;

struct PoseSearchTest : ::testing::Test {
    /// Rough pose found from a start that is off by `step`, its distance to the truth.
    Vector6d errorAfterWideSearch(const Vector6d& step)
    {
        const CentroidPose start = moved(truth, step);
        const StartPrior prior = startPrior(start, options);
        PoseRanking ranking(problem, target, prior);
        const PoseSearch search(problem, target, options);
        for (const CentroidPose& hypothesis : search.wide(start, [](double) { return Verdict::Continue; })) {
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
        step.head<3>() *= 15.0 * degree / step.head<3>().norm();
        step.tail<3>() *= 60.0 / step.tail<3>().norm();
        const Vector6d error = errorAfterWideSearch(step);
        EXPECT_LT(error.head<3>().norm(), 0.5 * degree);
        EXPECT_LT(error.segment<2>(3).norm(), 1.0);
    }
}

TEST_F(PoseSearchTest, RecentringMeetsTheTracedVessels)
{
    Vector6d step = Vector6d::Zero();
    step[3] = 300.0;
    const PoseSearch search(problem, target, options);
    const Vector6d error = stepBetween(truth, search.recentred(moved(truth, step)));
    EXPECT_LT(error.segment<2>(3).norm(), 15.0);
}

TEST_F(PoseSearchTest, RanksTheTruthAboveAllElse)
{
    PoseRanking ranking(problem, target, startPrior(truth, options));
    Vector6d aside = Vector6d::Zero();
    aside[3] = 40.0;
    ranking.add(moved(truth, aside));
    EXPECT_FALSE(ranking.isConclusive());
    ranking.add(truth);
    ranking.add(moved(truth, -aside));
    EXPECT_TRUE(ranking.isConclusive());
    EXPECT_LT(stepBetween(truth, ranking.best().pose).tail<3>().norm(), 1.0);
    EXPECT_EQ(ranking.distinct(1.0, 3).size(), 1u);
}

}   // namespace
}   // namespace core
