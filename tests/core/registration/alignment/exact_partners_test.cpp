#include "core/registration/alignment/exact_partners.h"

#include "core/support/random.h"
#include "tests/support/clean_case.h"

#include <gtest/gtest.h>

namespace angiopose::core {
namespace {

CentroidPose slightlyBeside(const CentroidPose& pose)
{
    Vector6d step;
    step << 1e-4, -1e-4, 1e-4, 0.02, 0.01, 0.1;
    return moved(pose, step);
}

TEST(ExactPartners, MakeThePoseExact)
{
    const test::CleanCase clean(2);
    const auto problem = makeProblem(clean.from(clean.truth), {}).value();
    const CentroidPose truth = aboutCentroid(clean.truth, problem.tree.centroid);
    const auto refined = ExactPartners(problem).refine(slightlyBeside(truth));
    ASSERT_TRUE(refined);
    EXPECT_LT(stepBetween(truth, *refined).norm(), 1e-8);
}

TEST(ExactPartners, AreNotSeenInNoisyPoints)
{
    test::CleanCase clean(2);
    CounterRandom random(5);
    for (Curve2d& curve : clean.target.curves) {
        for (Eigen::Vector2d& point : curve.pointsPx) {
            point += 0.05 * Eigen::Vector2d(random.normal(), random.normal());
        }
    }
    const auto problem = makeProblem(clean.from(clean.truth), {}).value();
    EXPECT_FALSE(ExactPartners(problem).refine(aboutCentroid(clean.truth, problem.tree.centroid)));
}

TEST(ExactPartners, AreNotSeenBetweenOtherSamplesOfTheSameCurves)
{
    test::CleanCase clean(2);
    clean.target = resampled(clean.target, 1.3);
    const auto problem = makeProblem(clean.from(clean.truth), {}).value();
    EXPECT_FALSE(ExactPartners(problem).refine(aboutCentroid(clean.truth, problem.tree.centroid)));
}

}   // namespace
}   // namespace angiopose::core