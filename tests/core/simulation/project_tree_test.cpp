#include "core/simulation/simulated_case.h"

#include <gtest/gtest.h>
#include <algorithm>
#include <limits>

using namespace angiopose;

namespace {

using namespace core;

const ProjectionCamera projectingCamera{-1877.0, 1877.0, 255.5, 255.5, 512, 512};

TEST(ProjectTree, GivesOneCurvePerBranchWithThePixelsOfItsPoints)
{
    const VesselTree tree = simulateTree(2);
    const RigidTransform pose{expSo3({0.2, 0.1, -0.4}), {2.0, -3.0, 800.0}};
    const Centerline2d target = projectTree(tree, projectingCamera, pose);
    ASSERT_EQ(target.curves.size(), tree.branches.size());
    for (std::size_t b = 0; b < target.curves.size(); ++b) {
        EXPECT_EQ(target.curves[b].id, tree.branches[b].id);
        ASSERT_EQ(target.curves[b].pointsPx.size(), tree.branches[b].pointsInPatient.size());
        const Eigen::Vector3d x = pose * tree.branches[b].pointsInPatient.back();
        EXPECT_NEAR(target.curves[b].pointsPx.back().x(), -1877.0 * x.x() / x.z() + 255.5, 1e-9);
        EXPECT_NEAR(target.curves[b].pointsPx.back().y(), 1877.0 * x.y() / x.z() + 255.5, 1e-9);
        EXPECT_NEAR(target.curves[b].radiusPx.back(), tree.branches[b].radiusMm.back() * 1877.0 / x.z(), 1e-9);
    }
}

/// Distance to the nearest point on the curve, not only to its vertices, px.
double distancePx(const Curve2d& curve, const Eigen::Vector2d& place)
{
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 1; i < curve.pointsPx.size(); ++i) {
        const Eigen::Vector2d along = curve.pointsPx[i] - curve.pointsPx[i - 1];
        const double share = std::clamp(along.dot(place - curve.pointsPx[i - 1]) / along.squaredNorm(), 0.0, 1.0);
        nearest = std::min(nearest, (curve.pointsPx[i - 1] + share * along - place).norm());
    }
    return nearest;
}

TEST(ProjectCurves, LieOnTheSameCurvesAndHaveNoPartners)
{
    const VesselTree tree = simulateTree(2);
    const RigidTransform pose{expSo3({0.2, 0.1, -0.4}), {2.0, -3.0, 800.0}};
    const Centerline2d own = projectTree(tree, projectingCamera, pose);
    const Centerline2d again = projectCurves(tree, projectingCamera, pose);
    ASSERT_EQ(again.curves.size(), own.curves.size());
    std::size_t partners = 0;
    std::size_t asked = 0;
    for (std::size_t c = 0; c < own.curves.size(); ++c) {
        const auto& points = again.curves[c].pointsPx;
        for (std::size_t i = 1; i + 1 < points.size(); ++i) {
            EXPECT_LT(distancePx(own.curves[c], points[i]), 1e-6);
            EXPECT_NEAR((points[i] - points[i - 1]).norm(), 1.0, 0.4);   // less across a sharp curve
            ++asked;
            partners += std::ranges::any_of(own.curves[c].pointsPx, [&](const Eigen::Vector2d& point) {
                return (point - points[i]).norm() < 1e-3;
            });
        }
        EXPECT_LT((points.front() - own.curves[c].pointsPx.front()).norm(), 1e-9);
    }
    EXPECT_GT(asked, 2000u);
    EXPECT_LT(partners, asked / 200);   // coincidental partners
}

TEST(ProjectTree, LeavesOutPointsBehindTheSource)
{
    VesselTree tree;
    tree.branches.push_back({1, "", {{0, 0, -50}, {0, 0, -20}, {0, 0, 40}, {0, 0, 60}}, {}});
    tree.branches.push_back({2, "", {{0, 0, -50}, {0, 0, -20}}, {}});
    const Centerline2d target = projectTree(tree, projectingCamera, RigidTransform{});
    ASSERT_EQ(target.curves.size(), 1u);
    EXPECT_EQ(target.curves[0].pointsPx.size(), 2u);
    EXPECT_TRUE(target.curves[0].radiusPx.empty());
}

}   // namespace
