#include "core/measuring/target_points.h"

#include "core/messages/messages.h"

#include <gtest/gtest.h>
#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <random>

namespace angiopose::core {
namespace {

/// A curved vessel in two views 90° apart, with a target point on it that is marked at its true position.
struct Checked {
    Checked()
    {
        VesselTree tree;
        tree.branches.push_back({1, "", {{-30, 0, 0}, {0, 10, 5}, {30, 0, -5}, {40, -20, 10}}, {}, 0});
        session.vessels.tree = std::make_shared<const VesselTree>(tree);
        session.vessels.marks = {{7, VesselMarkKind::TargetPoint, "fork", {25.0, 2.0, -4.0}}};
        session.views.resize(2);
        auto run = std::make_shared<Angiogram>();
        run->frames.assign(3, ImageF(512, 512));
        for (std::size_t k = 0; k < 2; ++k) {
            View& view = session.views[k];
            view.angiogram = run;
            view.frame = 1;
            view.geometry.cameraOverride = ProjectionCamera{-5000.0, 5200.0, 255.5, 255.5, 512, 512};
            view.cameraFromPatient.rotation = expSo3(Eigen::Vector3d(0.0, k == 0 ? 0.1 : 1.6, 0.05));
            view.cameraFromPatient.translation = {2.0, -3.0, 760.0 + 20.0 * static_cast<double>(k)};
            view.observations = {{7, seenAt(k, mark().pointInPatient), 1}};
        }
    }
    const VesselMark& mark() const { return session.vessels.marks.front(); }
    Eigen::Vector2d seenAt(std::size_t view, const Eigen::Vector3d& point) const
    {
        const View& in = session.views[view];
        return *project(cameraOf(in).value(), in.cameraFromPatient * point);
    }
    TargetPointResult checked() const { return evaluateTargetPoints(session).front(); }
    Case session;
};

/// A covariance with a different value for every pair of steps.
Matrix6d someCovariance(double scale)
{
    Matrix6d root;
    for (int row = 0; row < 6; ++row) {
        for (int column = 0; column < 6; ++column) {
            root(row, column) = std::sin(1.0 + 3.1 * row + 1.7 * column) * (row < 3 ? 1e-3 : 0.1);
        }
    }
    return scale * root * root.transpose();
}

}   // namespace

TEST(TargetPoints, TheErrorIsTheShiftThatWasImposed)
{
    Checked seen;
    EXPECT_NEAR(seen.checked().views[0].error.value().mm, 0.0, 1e-9);
    seen.session.views[0].cameraFromPatient.translation += Eigen::Vector3d(3.0, -4.0, 0.0);
    const TargetPointResult checked = seen.checked();
    ASSERT_EQ(checked.views.size(), 2U);
    const ImageError& error = checked.views[0].error.value();
    EXPECT_NEAR(error.mm, 5.0, 1e-9);
    const double depthMm = (seen.session.views[0].cameraFromPatient * seen.mark().pointInPatient).z();
    EXPECT_NEAR(error.depthMm, depthMm, 1e-9);
    EXPECT_NEAR(error.px, std::hypot(3.0 * 5000.0, 4.0 * 5200.0) / depthMm, 1e-9);
    EXPECT_NEAR(checked.views[1].error.value().mm, 0.0, 1e-9);
    EXPECT_FALSE(checked.views[0].predicted) << "no run found this pose";
    const Messages reported = sentencesOf(checked.views[0]);
    EXPECT_TRUE(reported.back().is(messages::checkNothingPredicted));
    EXPECT_EQ(labelOf(checked, 0)->text(), "error 5.0 mm");
}

TEST(TargetPoints, TwoViewsTellTheErrorInSpace)
{
    Checked seen;
    const Eigen::Vector3d shift(2.0, -1.0, 2.0);   // moves the vessels by 3 mm relative to both cameras
    for (std::size_t k = 0; k < 2; ++k) {
        seen.session.views[k].observations[0].pixel = seen.seenAt(k, seen.mark().pointInPatient + shift);
    }
    const TargetPointResult checked = seen.checked();
    ASSERT_TRUE(checked.triangulated) << checked.triangulated.error().message;
    EXPECT_NEAR(checked.spaceMm(), 3.0, 1e-7);
    EXPECT_LT((checked.triangulated.value().pointInPatient - seen.mark().pointInPatient - shift).norm(), 1e-7);
    EXPECT_NEAR(checked.triangulated.value().maxRayDistanceMm, 0.0, 1e-7);
    EXPECT_GT(checked.triangulated.value().angleDeg, 80.0);
    EXPECT_EQ(checked.triangulationViews, (std::vector<std::size_t>{0, 1}));

    seen.session.views[1].observations[0].pixel += Eigen::Vector2d(0.0, 20.0);   // the rays no longer meet
    EXPECT_GT(seen.checked().triangulated.value().maxRayDistanceMm, 0.5);
}

TEST(TargetPoints, NoErrorInSpaceWhereDepthCannotBeReported)
{
    Checked seen;
    seen.session.views[1].cameraFromPatient = seen.session.views[0].cameraFromPatient;
    seen.session.views[1].cameraFromPatient.translation.x() += 10.0;
    EXPECT_TRUE(seen.checked().triangulated.error().message.is(messages::checkRaysNearlyParallel));
    seen.session.views[1].observations.clear();
    EXPECT_TRUE(seen.checked().triangulated.error().message.is(messages::checkNeedsTwoViews));
    seen.session.views[0].observations.clear();
    EXPECT_TRUE(seen.checked().views.empty());
    EXPECT_FALSE(labelOf(seen.checked(), 0));
}

TEST(TargetPoints, ThePoseIsOfOneFrame)
{
    Checked seen;
    seen.session.views[0].observations[0].frame = 2;
    EXPECT_TRUE(seen.checked().views[0].error.error().message.is(messages::checkOtherFrame));
    EXPECT_FALSE(seen.checked().triangulated);
    seen.session.views[0].observations.push_back({7, {100.0, 100.0}, 1});
    EXPECT_TRUE(seen.checked().views[0].error) << "of several frames the one of the pose counts";
    seen.session.views[0].cameraFromPatient.translation.z() = -700.0;
    EXPECT_TRUE(seen.checked().views[0].error.error().message.is(messages::checkBehindSource));
}

TEST(TargetPoints, WhatIsClaimedIsWhatRandomPosesDo)
{
    Checked seen;
    View& view = seen.session.views[0];
    view.result.emplace();
    view.result->cameraFromPatient = view.cameraFromPatient;
    const Matrix6d covariance = someCovariance(0.01);
    view.result->uncertainty.covariance = covariance;
    view.result->uncertainty.imageCovariance = covariance;
    const PredictedError predicted = *seen.checked().views[0].predicted;

    const Eigen::Vector3d centroid = centroidInPatient(*seen.session.vessels.tree);
    const Eigen::LLT<Matrix6d> root(Matrix6d(covariance + 1e-15 * Matrix6d::Identity()));
    std::mt19937 random(5);
    std::normal_distribution<double> normal;
    double inPlane = 0.0;
    double inSpace = 0.0;
    constexpr int draws = 40000;
    for (int i = 0; i < draws; ++i) {
        const Vector6d step = root.matrixL() * Vector6d::NullaryExpr([&] { return normal(random); });
        RigidTransform moved;
        moved.rotation = expSo3(step.head<3>()) * view.cameraFromPatient.rotation;
        moved.translation = view.cameraFromPatient * centroid + step.tail<3>() - moved.rotation * centroid;
        const Eigen::Vector2d at = *project(cameraOf(view).value(), moved * seen.mark().pointInPatient);
        const auto error = imageError({cameraOf(view).value(), view.cameraFromPatient}, seen.mark().pointInPatient, at);
        inPlane += error.value().mm * error.value().mm / draws;
        inSpace +=
            (moved * seen.mark().pointInPatient - view.cameraFromPatient * seen.mark().pointInPatient).squaredNorm() /
            draws;
    }
    EXPECT_GT(predicted.inPlaneMm, 1e-3);
    EXPECT_NEAR(std::sqrt(inPlane) / predicted.inPlaneMm, 1.0, 0.02);
    EXPECT_NEAR(std::sqrt(inSpace) / predicted.spaceMm, 1.0, 0.02);
    EXPECT_TRUE(sentencesOf(seen.checked().views[0])[1].is(messages::checkPredicted));
}

TEST(TargetPoints, APoseLookedAtForAWhileHasNoClaim)
{
    Checked seen;
    seen.session.views[0].result.emplace();
    seen.session.views[0].result->cameraFromPatient = seen.session.views[0].cameraFromPatient;
    EXPECT_TRUE(seen.checked().views[0].predicted);
    const auto moved = evaluateTargetPoints(seen.session, [&](std::size_t view) {
        RigidTransform pose = seen.session.views[view].cameraFromPatient;
        pose.translation.x() += 1.0;
        return pose;
    });
    EXPECT_FALSE(moved.front().views[0].predicted);
    EXPECT_NEAR(moved.front().views[0].error.value().mm, 1.0, 1e-9);
}

}   // namespace angiopose::core
