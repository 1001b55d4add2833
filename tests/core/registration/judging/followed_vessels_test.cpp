#include "core/registration/judging/followed_vessels.h"

#include "core/registration/matching/grid_index.h"
#include "tests/support/clean_case.h"

#include <gtest/gtest.h>

namespace angiopose::core {
namespace {

struct FollowedVesselsTest : ::testing::Test {
    FollowedVessels at(const RigidTransform& pose) const
    {
        const GridIndex index(problem.target.points);
        return followedVessels(problem, lines, pose, projectTree(problem, pose, index));
    }

    test::CleanCase clean{4};
    RegistrationProblem problem = makeProblem(clean.from(clean.truth), {}).value();
    TargetLines lines{problem.target, problem.camera};
};

TEST_F(FollowedVesselsTest, AllAreAtTheTruth)
{
    const FollowedVessels followed = at(clean.truth);
    EXPECT_GT(followed.share(),
              0.9);   // not all: where two vessels cross, the nearer curve may belong to the other one
    EXPECT_GT(followed.branchesInView, 15);
    EXPECT_GE(followed.branchesFollowed, followed.branchesInView - 1);
}

TEST_F(FollowedVesselsTest, CrossingsAreNotFollowed)
{
    RigidTransform aside = clean.truth;
    aside.translation += Eigen::Vector3d(25.0, 15.0, 0.0);
    EXPECT_LT(at(aside).share(), 0.1);
    EXPECT_LE(at(aside).branchesFollowed, 1);
}

TEST_F(FollowedVesselsTest, WhatIsOutsideTheImageIsNotMissed)
{
    const double wholeMm = at(clean.truth).inViewMm;
    problem.camera.width = 512;   // the left half of the image
    const FollowedVessels followed = at(clean.truth);
    EXPECT_LT(followed.inViewMm, 0.8 * wholeMm);
    EXPECT_GT(followed.share(), 0.9);
}

}   // namespace
}   // namespace angiopose::core
