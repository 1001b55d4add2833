#include "core/workflow/track_frames.h"

#include "core/case/known_deformation.h"
#include "core/workflow/register_case.h"
#include "tests/support/drawn_vessels.h"
#include "tests/support/simulated_views.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

namespace angiopose::core {
namespace {

/// A run of vessels that are deformed in all of its frames, traced and registered.
Case registeredRun(double deformedStdMm)
{
    DsaOptions dsa;
    dsa.nonRigidStdMm = deformedStdMm;
    dsa.missingBranchShare = dsa.extraBranchShare = dsa.catheterProbability = dsa.shutterProbability = 0.0;
    Case values = test::caseOf(simulateCase(5, {}, dsa));
    values.shown().target.centerline = nullptr;   // traced for each frame
    const auto registered = registerCase(values, {}, {});
    EXPECT_TRUE(registered);
    return registered.value().session;
}

TEST(FollowFrames, FollowsDeformedVesselsDeformed)
{
    Case session = registeredRun(3.0);
    ASSERT_TRUE(knownDeformation(session.shown(), session.vessels, session.shown().cameraFromPatient));
    const auto frames = trackFrames(session);
    ASSERT_TRUE(frames);
    int found = 0;
    int carried = 0;
    for (const TrackedRunFrame& each : frames.value()) {
        EXPECT_TRUE(each.deformed) << each.frame;
        EXPECT_EQ(each.deformationSourceFrame.has_value(), !each.tracked.isTrustworthy) << each.frame;
        (each.deformationSourceFrame ? carried : found) += 1;
    }
    EXPECT_GE(found, 3);
    EXPECT_GE(carried, 1) << "frames without contrast";
    session.shown().followed = makeTrackedRun(session.shown().frame, frames.value());
    for (const TrackedRunFrame& each : frames.value()) {
        const auto known = knownDeformation(session.shown(), session.vessels, each.tracked.cameraFromPatient);
        ASSERT_TRUE(known) << each.frame;   // lost frames may share a pose
        EXPECT_TRUE(known->cameraFromPatient.matrix().isApprox(each.deformed->cameraFromPatient.matrix()))
            << each.frame;
        const View there = withFrame(session.shown(), each.frame);
        EXPECT_EQ(there.cameraFromPatient.matrix(), each.tracked.cameraFromPatient.matrix()) << each.frame;
        EXPECT_FALSE(there.result);
    }
    applyRegistration(session.shown(), *session.shown().result);
    EXPECT_FALSE(session.shown().followed.frames) << "another pose may follow from it";
}

/// Stationary objects at the vessels' positions match their pose even in frames without contrast agent.
TEST(FollowFrames, DoesNotTrustWhatStandsStillWithoutContrast)
{
    DsaOptions dsa;
    dsa.missingBranchShare = dsa.extraBranchShare = dsa.catheterProbability = dsa.shutterProbability = 0.0;
    SimulatedCase simulated = simulateCase(5, {}, dsa);
    std::vector<test::Path> things;
    for (std::size_t k = 0; k < simulated.trueTarget.curves.size(); k += 3) {
        things.push_back(simulated.trueTarget.curves[k].pointsPx);
    }
    Angiogram& run = simulated.angiogram;
    const ImageF shadow = test::drawnFrame(run.width(), run.height(), things, 3.0, {.background = 1.0F, .depth = 0.6F});
    for (ImageF& frame : run.frames) {
        std::ranges::transform(frame.pixels, shadow.pixels, frame.pixels.begin(), std::multiplies<>());
    }
    Case values = test::caseOf(simulated);
    values.shown().target.centerline = nullptr;
    values.shown().cameraFromPatient = simulated.trueCameraFromPatient;
    const auto frames = trackFrames(values);
    ASSERT_TRUE(frames) << frames.error().message;
    const TrackedRunFrame& first = frames.value().front();
    EXPECT_EQ(first.frame, 0) << "before the contrast agent";
    EXPECT_FALSE(first.tracked.isTrustworthy);
    ASSERT_TRUE(first.problem);
    EXPECT_EQ(first.problem->id(), "follow.stands-still");
}

TEST(FollowFrames, FindsNoDeformationWhereNoneIsKnown)
{
    Case session = registeredRun(0.0);
    const auto frames = trackFrames(session);
    ASSERT_TRUE(frames);
    EXPECT_TRUE(std::ranges::all_of(frames.value(), [](const TrackedRunFrame& each) { return !each.deformed; }));
}

}   // namespace
}   // namespace angiopose::core
