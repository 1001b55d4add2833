#include "core/registration/judging/distance_metrics.h"

#include "core/registration/matching/grid_index.h"
#include "tests/support/clean_case.h"

#include <gtest/gtest.h>

namespace angiopose::core {
namespace {

struct DistanceMetricsTest : ::testing::Test {
    DistanceMetrics metricsAt(const RigidTransform& pose) const
    {
        const GridIndex index(problem.target.points);
        return distanceMetrics(problem, pose, projectTree(problem, pose, index));
    }

    test::CleanCase clean{4};
    RegistrationProblem problem = makeProblem(clean.from(clean.truth), {}).value();
};

TEST_F(DistanceMetricsTest, TruthHasNoDistanceAndFullCoverage)
{
    const DistanceMetrics metrics = metricsAt(clean.truth);
    EXPECT_LT(metrics.medianPx, 0.02);
    EXPECT_LT(metrics.reverseMeanPx, 0.1);
    EXPECT_DOUBLE_EQ(metrics.coverage, 1.0);
    EXPECT_NEAR(metrics.meanMm / metrics.meanPx, 800.0 / 1877.0, 1e-2);
}

TEST_F(DistanceMetricsTest, BehindTheSourceCostsTheImageDiagonal)
{
    RigidTransform behind = clean.truth;
    behind.translation.z() -= 1600.0;
    const DistanceMetrics metrics = metricsAt(behind);
    EXPECT_DOUBLE_EQ(metrics.medianPx, std::hypot(1024.0, 1024.0));
    EXPECT_EQ(metrics.coverage, 0.0);
}

TEST_F(DistanceMetricsTest, ShrinkingTheProjectionShowsInTheReverseDistance)
{
    RigidTransform far = clean.truth;
    far.translation *= 20.0;
    EXPECT_GT(metricsAt(far).reverseMeanPx, 20.0 * metricsAt(clean.truth).reverseMeanPx);
    EXPECT_LT(metricsAt(far).coverage, 0.2);
}

}   // namespace
}   // namespace angiopose::core
