#include "core/registration/depth_constraint.h"

#include "core/messages/messages.h"
#include "core/registration/judging/pose_shift.h"
#include "core/registration/registration.h"
#include "tests/support/clean_case.h"

#include <gtest/gtest.h>
#include <algorithm>

namespace angiopose::core {
namespace {

/// One straight vessel across the rays, whose depth the image does not determine. The initial pose is 40 mm too deep.
RegistrationInput straightVessel()
{
    RegistrationInput input;
    VesselBranch branch;
    branch.id = 1;
    for (int i = 0; i <= 100; ++i) {
        branch.pointsInPatient.emplace_back(i - 50.0, 0.0, 0.0);
    }
    input.tree.branches = {branch};
    input.camera = {-1877.0, 1877.0, 511.5, 511.5, 1024, 1024};
    input.initialCameraFromPatient.translation = {0.0, 0.0, 840.0};
    RigidTransform truth;
    truth.translation = {0.0, 0.0, 800.0};
    Curve2d curve;
    for (const Eigen::Vector3d& point : branch.pointsInPatient) {
        curve.pointsPx.push_back(*project(input.camera, truth * point));
    }
    input.target.curves = {curve};
    return input;
}

TEST(DepthConstraint, AnUnseenDepthStaysAtTheStartAndTheSentenceSaysSo)
{
    const RegistrationInput input = straightVessel();
    const RegistrationResult result = registerVessels(input).value();
    ASSERT_FALSE(result.uncertainty.observed[5]);
    const RegistrationProblem problem = makeProblem(input, {}).value();
    EXPECT_LT(std::abs(depthShiftMm(problem, result.cameraFromPatient)), 2.5);
    EXPECT_TRUE(
        std::ranges::any_of(result.warnings, [](const Message& each) { return each.is(messages::depthUndetermined); }));
}

TEST(DepthConstraint, APoseThatLeftTheStartIsSaidToHaveLeftIt)
{
    const RegistrationInput input = straightVessel();
    RigidTransform deeper;
    deeper.translation = {0.0, 0.0, 900.0};
    const RegistrationResult result = evaluatePose(input, deeper).value();
    ASSERT_FALSE(result.uncertainty.observed[5]);
    EXPECT_TRUE(std::ranges::any_of(result.warnings,
                                    [](const Message& each) { return each.is(messages::depthChangeUndetermined); }));
}

TEST(DepthConstraint, ADepthThatTheImageTellsIsLeftAlone)
{
    const test::CleanCase clean(3);
    RigidTransform deep = clean.truth;
    deep.translation.z() += 20.0;
    const RegistrationResult result = registerVessels(clean.from(deep)).value();
    EXPECT_TRUE(result.uncertainty.observed[5]);
    EXPECT_NEAR((result.cameraFromPatient * centroidInPatient(clean.tree)).z(), 800.0, 1.0);
}

}   // namespace
}   // namespace angiopose::core
