#include "core/registration/alignment/coarse_search.h"

#include "core/registration/alignment/alignment_points.h"
#include "tests/support/clean_case.h"

#include <gtest/gtest.h>
#include <numbers>

namespace angiopose::core {
namespace {

struct CoarseSearchTest : ::testing::Test {
    CoarseSearchTest()
        : problem(makeProblem(clean.from(clean.truth), {}).value()),
          target(problem.target, problem.camera),
          points(alignmentPoints(problem.tree, problem.tree.size() / 90 + 1)),
          truth(aboutCentroid(clean.truth, problem.tree.centroid))
    {
    }

    test::CleanCase clean{1};
    RegistrationProblem problem;
    TargetLines target;
    std::vector<AlignmentPoint> points;
    CentroidPose truth;
};

TEST_F(CoarseSearchTest, LandsInTheBasinOfAFarTruth)
{
    constexpr double degree = std::numbers::pi / 180.0;
    Vector6d step;
    step << 7.0 * degree, -6.0 * degree, 8.0 * degree, 40.0, -35.0, 15.0;
    const auto candidates =
        CoarseSearch(problem.camera, target).find(points, retract(truth, step), {60.0, 10.0, 10.0}, [](double) {
            return ObserverDecision::Continue;
        });
    ASSERT_FALSE(candidates.empty());
    const Vector6d off = stepBetween(truth, candidates.front().pose);
    EXPECT_LT(off.head<3>().norm(), 8.0 * degree);
    EXPECT_LT(off.segment<2>(3).norm(), 12.0);
}

TEST_F(CoarseSearchTest, StopsWhenReported)
{
    int asked = 0;
    const auto candidates = CoarseSearch(problem.camera, target).find(points, truth, {60.0, 10.0, 10.0}, [&](double) {
        return ++asked == 2 ? ObserverDecision::Stop : ObserverDecision::Continue;
    });
    EXPECT_EQ(asked, 2);
    EXPECT_FALSE(candidates.empty());
}

TEST_F(CoarseSearchTest, ReachOfZeroLooksOnlyAtTheStart)
{
    const auto candidates = CoarseSearch(problem.camera, target).find(points, truth, {0.0, 0.0, 0.0}, [](double) {
        return ObserverDecision::Continue;
    });
    ASSERT_EQ(candidates.size(), 1u);
    EXPECT_LT(stepBetween(truth, candidates.front().pose).norm(), 1e-12);
    EXPECT_GT(candidates.front().score, 0.9);
}

}   // namespace
}   // namespace angiopose::core
