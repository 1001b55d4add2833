#include "core/vessel/vessel_mark.h"

#include "core/geometry/projection_camera.h"
#include "core/geometry/rigid_transform.h"
#include "core/vessel/tree_position.h"

#include <gtest/gtest.h>
#include <Eigen/Geometry>
#include <numbers>

namespace angiopose::core {
namespace {

VesselTree bow()
{
    VesselTree tree;
    VesselBranch& branch = tree.branches.emplace_back();
    branch.id = 3;
    for (int i = 0; i <= 60; ++i) {
        const double angle = std::numbers::pi * i / 60.0;
        branch.pointsInPatient.emplace_back(30.0 * std::cos(angle), 30.0 * std::sin(angle), 0.1 * i);
        branch.radiusMm.push_back(1.0 + 0.01 * i);
    }
    return tree;
}

}   // namespace

TEST(VesselMark, ProjectsAsTheOutlineOfItsDisc)
{
    const VesselMark ring{
        1, VesselMarkKind::OstiumRing, "", {4.0, -3.0, 7.0}, Eigen::Vector3d(1, 2, -0.5).normalized(), 2.5};
    const ProjectionCamera camera{-4000.0, 4200.0, 255.5, 250.0, 512, 512};
    RigidTransform pose;
    pose.rotation = expSo3({0.4, -0.7, 0.2});
    pose.translation = {10.0, -5.0, 760.0};
    const RigidTransform patientFromCamera = pose.inverse();
    const std::vector<Eigen::Vector3d> points = ringPoints(ring, 72);
    ASSERT_EQ(points.size(), 72U);
    for (const Eigen::Vector3d& point : points) {   // back-projected along each pixel's ray onto the plane of the ring
        const auto pixel = project(camera, pose * point);
        ASSERT_TRUE(pixel);
        const Eigen::Vector3d way = patientFromCamera.rotation * rayThroughPixel(camera, *pixel);
        const Eigen::Vector3d& source = patientFromCamera.translation;
        const double far = (ring.pointInPatient - source).dot(ring.normal) / way.dot(ring.normal);
        EXPECT_NEAR((source + far * way - ring.pointInPatient).norm(), 2.5, 1e-6);
    }
}

TEST(VesselMark, TangentAndRadiusAreThoseOfTheBranch)
{
    const VesselTree tree = bow();
    const auto place = nearestPosition(tree, tree.branches[0].pointsInPatient[20]);
    ASSERT_TRUE(place);
    const double angle = std::numbers::pi * 20 / 60.0;
    const Eigen::Vector3d tangent =
        Eigen::Vector3d(-30.0 * std::sin(angle), 30.0 * std::cos(angle), 0.1 * 60.0 / std::numbers::pi).normalized();
    EXPECT_GT(directionAt(tree, *place).dot(tangent), 0.9999);
    EXPECT_NEAR(*radiusAt(tree, *place), 1.2, 1e-9);
    const auto end = nearestPosition(tree, tree.branches[0].pointsInPatient.back());
    EXPECT_NEAR(directionAt(tree, *end).norm(), 1.0, 1e-12);
    EXPECT_NEAR(*radiusAt(tree, *end), 1.6, 1e-9);
    VesselTree bare = tree;
    bare.branches[0].radiusMm.clear();
    EXPECT_FALSE(radiusAt(bare, *place));
}

TEST(VesselMark, GoesWithDeformedVessels)
{
    const VesselTree tree = bow();
    VesselTree moved = tree;
    const Eigen::Matrix3d turn = expSo3({0.0, 0.3, 0.5});
    for (Eigen::Vector3d& point : moved.branches[0].pointsInPatient) {
        point = turn * point + Eigen::Vector3d(3, 2, 1);
    }
    VesselMark ring{1, VesselMarkKind::OstiumRing, "", tree.branches[0].pointsInPatient[31], {}, 1.0};
    ring.normal = directionAt(tree, *nearestPosition(tree, ring.pointInPatient));
    const VesselMark with = moveWithVessels(tree, moved, ring);
    EXPECT_LT((with.pointInPatient - (turn * ring.pointInPatient + Eigen::Vector3d(3, 2, 1))).norm(), 1e-9);
    EXPECT_GT(with.normal.dot(turn * ring.normal), 1.0 - 1e-9);
    EXPECT_LT((moveWithVessels(moved, tree, with).pointInPatient - ring.pointInPatient).norm(), 1e-9);
    VesselTree other = moved;
    other.branches[0].pointsInPatient.pop_back();
    EXPECT_EQ(moveWithVessels(tree, other, ring), ring);
    EXPECT_EQ(moveWithVessels({}, {}, ring), ring);
}

TEST(VesselMark, IdsAreNotUsedTwice)
{
    EXPECT_EQ(nextMarkId({}), 1);
    VesselMark third;
    third.id = 3;
    EXPECT_EQ(nextMarkId({third, VesselMark()}), 4);
}

}   // namespace angiopose::core
