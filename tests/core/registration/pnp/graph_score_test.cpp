#include "core/registration/pnp/graph_score.h"

#include "tests/support/clean_case.h"

#include <gtest/gtest.h>

namespace angiopose::core {
namespace {

TEST(GraphScore, IsBestWhereTheTreeLiesOnItsImage)
{
    const test::CleanCase clean{4};
    const RegistrationProblem problem = makeProblem(clean.from(clean.truth), {}).value();
    const GraphScore score(problem, 0.1);
    const CentroidPose truth = aboutCentroid(clean.truth, problem.tree.centroid);
    CentroidPose shifted = truth;
    shifted.centroidInCamera.x() += 10.0;
    CentroidPose shrunk = truth;
    shrunk.centroidInCamera *= 4.0;   // along the ray: the whole tree covers only a small part of the image
    EXPECT_GT(score.scoreAt(truth), 0.5);
    EXPECT_GT(score.scoreAt(truth), score.scoreAt(shifted) + 0.1);
    EXPECT_GT(score.scoreAt(truth), score.scoreAt(shrunk) + 0.1);
}

TEST(GraphScore, IsMinusInfinityBehindTheSource)
{
    const test::CleanCase clean{4};
    const RegistrationProblem problem = makeProblem(clean.from(clean.truth), {}).value();
    CentroidPose behind = aboutCentroid(clean.truth, problem.tree.centroid);
    behind.centroidInCamera.z() = -1000.0;
    EXPECT_LT(GraphScore(problem, 0.1).scoreAt(behind), -1e300);
}

}   // namespace
}   // namespace angiopose::core
