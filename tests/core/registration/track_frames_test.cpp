#include "core/registration/track_frames.h"

#include "core/evaluation/trial/projection_error.h"
#include "tests/support/clean_case.h"

#include <gtest/gtest.h>
#include <cmath>
#include <numbers>

namespace angiopose::core {
namespace {

constexpr double framesPerBreath = 60.0;

/// A run in which the tree moves with respiration, 10 mm up and down and 3° of tilt, with jittered points.
struct BreathingRun {
    RigidTransform truthAt(int frame) const
    {
        const double phase = 0.5 - 0.5 * std::cos(2.0 * std::numbers::pi * frame / framesPerBreath);
        Vector6d motion;
        motion << 0.05 * phase, 0.0, 0.01 * phase, 1.0 * phase, 10.0 * phase, -2.0 * phase;
        const Eigen::Vector3d centroid = centroidInPatient(clean.tree);
        return cameraFromPatient(retract(aboutCentroid(clean.truth, centroid), motion), centroid);
    }

    Centerline2d targetAt(int frame)
    {
        return test::jittered(projectTree(clean.tree, clean.camera, truthAt(frame)), random);
    }

    FrameTracker tracker() const { return {makeProblem(clean.from(clean.truth), options).value(), options}; }

    double errorPx(const RigidTransform& pose, int frame) const
    {
        return projectionError(clean.tree, clean.camera, {pose, truthAt(frame)}).meanPx;
    }

    RegistrationOptions options;
    CounterRandom random{11};
    test::CleanCase clean{4};
};

TEST(FrameTracker, FollowsBreathingWithoutSearching)
{
    BreathingRun run;
    FrameTracker tracker = run.tracker();
    for (int frame = 1; frame <= 90; ++frame) {
        const auto tracked = tracker.next(run.targetAt(frame));
        ASSERT_TRUE(tracked);
        EXPECT_TRUE(tracked.value().isTrustworthy);
        EXPECT_FALSE(tracked.value().isFromSearch) << "frame " << frame;
        EXPECT_LT(run.errorPx(tracked.value().cameraFromPatient, frame), 0.5) << "frame " << frame;
    }
}

TEST(FrameTracker, SearchesAfterAJump)
{
    BreathingRun run;
    FrameTracker tracker = run.tracker();
    for (int frame = 1; frame <= 5; ++frame) {
        ASSERT_TRUE(tracker.next(run.targetAt(frame)));
    }
    const Eigen::Vector3d centroid = centroidInPatient(run.clean.tree);
    Vector6d jump = Vector6d::Zero();
    jump[3] = 30.0;   // a table movement
    run.clean.truth = cameraFromPatient(retract(aboutCentroid(run.clean.truth, centroid), jump), centroid);
    for (int frame = 6; frame <= 8; ++frame) {
        const auto tracked = tracker.next(run.targetAt(frame));
        ASSERT_TRUE(tracked);
        EXPECT_EQ(tracked.value().isFromSearch, frame == 6);
        EXPECT_TRUE(tracked.value().isTrustworthy);
        EXPECT_LT(run.errorPx(tracked.value().cameraFromPatient, frame), 0.5);
    }
}

TEST(FrameTracker, HearsStopWhileItSearches)
{
    BreathingRun run;
    FrameTracker tracker = run.tracker();
    ASSERT_TRUE(tracker.next(run.targetAt(1)));
    Centerline2d elsewhere = run.targetAt(2);
    for (Curve2d& curve : elsewhere.curves) {
        for (Eigen::Vector2d& point : curve.pointsPx) {
            point.x() += 60.0;
        }
    }
    FrameTracker undisturbed = tracker;
    int heard = 0;
    const auto count = [&heard](double) { return ++heard, ObserverDecision::Continue; };
    ASSERT_TRUE(undisturbed.next(elsewhere, count).value().isFromSearch);
    const int whole = heard;
    heard = 0;
    const auto stop = [&heard](double) { return ++heard, ObserverDecision::Stop; };
    ASSERT_TRUE(tracker.next(elsewhere, stop).value().isFromSearch);
    EXPECT_GT(whole, 3);
    EXPECT_LE(heard, 2);
}

TEST(FrameTracker, SaysWhenTheVesselsAreGoneAndFindsThemAgain)
{
    BreathingRun run;
    FrameTracker tracker = run.tracker();
    for (int frame = 1; frame <= 3; ++frame) {
        ASSERT_TRUE(tracker.next(run.targetAt(frame)));
    }
    Centerline2d wire;   // the contrast agent has washed out and only a wire remains
    wire.curves.push_back({1, {}, {}});
    for (int i = 0; i < 300; ++i) {
        wire.curves.back().pointsPx.emplace_back(100.0 + i, 900.0 - 0.2 * i);
    }
    for (int frame = 4; frame <= 6; ++frame) {
        const auto tracked = tracker.next(wire);
        ASSERT_TRUE(tracked);
        EXPECT_FALSE(tracked.value().isTrustworthy);
    }
    const auto again = tracker.next(run.targetAt(7));
    ASSERT_TRUE(again);
    EXPECT_TRUE(again.value().isTrustworthy);
    EXPECT_LT(run.errorPx(again.value().cameraFromPatient, 7), 0.5);
}

TEST(FrameTracker, RefusesABrokenTargetAndGoesOn)
{
    BreathingRun run;
    FrameTracker tracker = run.tracker();
    Centerline2d broken = run.targetAt(1);
    broken.curves.front().pointsPx.front().x() = std::nan("");
    EXPECT_FALSE(tracker.next(broken));
    const auto tracked = tracker.next(run.targetAt(1));
    ASSERT_TRUE(tracked);
    EXPECT_TRUE(tracked.value().isTrustworthy);
}

TEST(MotionModel, LearnsTheAxisOfTheMotion)
{
    CentroidPose pose;
    pose.centroidInCamera = {0.0, 0.0, 800.0};
    MotionModel model(pose, 60.0, {});
    Vector6d step = Vector6d::Zero();
    step[4] = 1.5;
    for (int k = 0; k < 6; ++k) {
        pose = retract(pose, step);
        model.advance(pose);
    }
    EXPECT_LT((stepBetween(pose, model.predict().start) - step).norm(), 1e-9);
    const double before = model.predict().std()[3];
    model.advance({});
    EXPECT_LT(stepBetween(pose, model.predict().start).norm(), 1e-9);
    EXPECT_GT(model.predict().std()[3], before);
}

}   // namespace
}   // namespace angiopose::core
