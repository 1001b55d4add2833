#include "core/viewing/view_evaluator.h"

#include <gtest/gtest.h>

#include <numbers>

namespace angiopose::core {
namespace {

/// A straight branch of radius 2 mm with the given ends, in mm.
VesselBranch straight(int id, const Eigen::Vector3d& from, const Eigen::Vector3d& to)
{
    return {id, "", {from, to}, {2.0, 2.0}, -1};
}

/// A pose 10 m in front of the patient (a nearly parallel beam), rotated by `deg` about the patient's long axis.
RigidTransform fromTheFront(double deg = 0.0)
{
    const double turn = deg * std::numbers::pi / 180.0;
    Eigen::Matrix3d rotation;
    rotation << -std::cos(turn), -std::sin(turn), 0.0,   // camera x: toward the patient's right
        0.0, 0.0, -1.0,   // camera y: toward the feet
        std::sin(turn), -std::cos(turn), 0.0;   // camera z: toward the front
    return {rotation, {0.0, 0.0, 10000.0}};
}

ViewQuality qualityOf(const VesselTree& tree, const RigidTransform& cameraFromPatient)
{
    const auto all = vesselSegmentsOf(tree);
    return ViewEvaluator(branchSegments(all, 1), all).from(cameraFromPatient);
}

TEST(ViewEvaluator, SeesAVesselAcrossTheRayInFullAndOneAlongItEndOn)
{
    const VesselTree upright{{straight(1, {0, 0, -20}, {0, 0, 20})}};
    EXPECT_NEAR(qualityOf(upright, fromTheFront()).foreshortening, 0.0, 1e-5);
    const VesselTree forwards{{straight(1, {0, -20, 0}, {0, 20, 0})}};
    EXPECT_NEAR(qualityOf(forwards, fromTheFront()).foreshortening, 1.0, 1e-5);
    EXPECT_NEAR(qualityOf(forwards, fromTheFront(30.0)).foreshortening, 1.0 - std::sin(std::numbers::pi / 6.0), 1e-5);
}

TEST(ViewEvaluator, CountsWhatLiesOverAVessel)
{
    const VesselTree behind{{straight(1, {0, 0, -20}, {0, 0, 20}), straight(2, {0, 30, -20}, {0, 30, 20})}};
    EXPECT_NEAR(qualityOf(behind, fromTheFront()).overlap, 1.0, 0.01);
    EXPECT_NEAR(qualityOf(behind, fromTheFront(30.0)).overlap, 0.0, 1e-9);

    const VesselTree halfBehind{{straight(1, {0, 0, -20}, {0, 0, 20}), straight(2, {2, 30, -20}, {2, 30, 20})}};
    EXPECT_NEAR(qualityOf(halfBehind, fromTheFront()).overlap, 0.5, 0.02);

    const VesselTree shortOne{{straight(1, {0, 0, -20}, {0, 0, 20}), straight(2, {0, 30, 0}, {0, 30, 20})}};
    EXPECT_NEAR(qualityOf(shortOne, fromTheFront()).overlap, 0.5, 0.06);
}

TEST(ViewEvaluator, DoesNotCountWhatTouchesInSpace)
{
    const VesselTree crossing{{straight(1, {0, 0, -20}, {0, 0, 20}), straight(2, {-20, 0, 0}, {20, 0, 0})}};
    EXPECT_DOUBLE_EQ(qualityOf(crossing, fromTheFront()).overlap, 0.0);
}

TEST(ViewEvaluator, CountsWhatALoopLaysOverItself)
{
    VesselBranch loop{1, "", {}, {}, -1};
    for (int i = 0; i <= 60; ++i) {
        const double turn = 2.0 * std::numbers::pi * i / 60.0;
        loop.pointsInPatient.emplace_back(0.0, 30.0 * std::cos(turn), 30.0 * std::sin(turn));
        loop.radiusMm.push_back(2.0);
    }
    EXPECT_GT(qualityOf({{loop}}, fromTheFront()).overlap, 0.7);
    EXPECT_LT(qualityOf({{loop}}, fromTheFront(60.0)).overlap, 0.05);
}

TEST(ViewEvaluator, TakesWhatLiesBehindTheSourceForUnseen)
{
    const VesselTree upright{{straight(1, {0, 0, -20}, {0, 0, 20})}};
    RigidTransform behind = fromTheFront();
    behind.translation.z() = -100.0;
    const ViewQuality quality = qualityOf(upright, behind);
    EXPECT_DOUBLE_EQ(quality.foreshortening, 1.0);
    EXPECT_DOUBLE_EQ(quality.overlap, 1.0);
}

TEST(VesselPieces, OfATakeOffAreThoseOfAllBranchesThatMeetThere)
{
    const VesselTree tree{{straight(1, {0, 0, -40}, {0, 0, 40}), straight(2, {0, 0, 0}, {30, 0, 10}),
                           straight(3, {200, 0, 0}, {230, 0, 0})}};
    const auto pieces = takeoffSegments(tree, 2, 10.0);
    ASSERT_TRUE(pieces);
    double lengthMm = 0.0;
    for (const VesselSegment& piece : pieces.value()) {
        lengthMm += piece.alongMm.norm();
        EXPECT_LE(piece.midpointInPatient.norm(), 10.0);
    }
    EXPECT_NEAR(lengthMm, 30.0, 3.0);
    EXPECT_EQ(takeoffSegments(tree, 3).error().message.id(), "tree.no-take-off");
    EXPECT_EQ(takeoffSegments(tree, 4).error().message.id(), "tree.no-such-branch");
}

}   // namespace
}   // namespace angiopose::core
