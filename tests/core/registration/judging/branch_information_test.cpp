#include "core/registration/judging/branch_information.h"

#include <gtest/gtest.h>
#include <algorithm>

using namespace angiopose;

namespace {

using namespace core;

const ProjectionCamera crossCamera{-2000.0, 2000.0, 255.5, 255.5, 512, 512};
const RigidTransform pose{Eigen::Matrix3d::Identity(), {0.0, 0.0, 750.0}};
const Vector6d prior = (Vector6d() << 0.1, 0.1, 0.1, 20.0, 20.0, 40.0).finished();

VesselBranch line(int id, const Eigen::Vector3d& from, const Eigen::Vector3d& to)
{
    VesselBranch branch;
    branch.id = id;
    for (int i = 0; i <= 40; ++i) {
        branch.pointsInPatient.emplace_back(from + (to - from) * i / 40.0);
    }
    return branch;
}

/// Branches: horizontal (1), vertical (2), a short one along the first (3) and one outside the image (4).
VesselTree cross()
{
    return {{line(1, {-50, 0, 0}, {50, 0, 0}), line(2, {0, -50, 0}, {0, 50, 0}), line(3, {10, 0, 0}, {14, 0, 0}),
             line(4, {300, 300, 0}, {350, 300, 0})}};
}

TEST(BranchInformation, SeesOnlyAcrossTheVessel)
{
    const auto reported = branchInformation(cross(), crossCamera, pose);
    ASSERT_EQ(reported.size(), 4u);
    EXPECT_LT(reported[0].information(3, 3), 1e-9);   // no information along a vessel
    EXPECT_GT(reported[0].information(4, 4), 1.0);
    EXPECT_GT(reported[1].information(3, 3), 1.0);
    EXPECT_LT(reported[1].information(4, 4), 1e-9);
    EXPECT_NEAR(reported[0].lengthPx, 100.0 * 2000.0 / 750.0, 0.1);
}

TEST(BranchInformation, LeavesOutWhatLiesOutsideTheImage)
{
    const auto reported = branchInformation(cross(), crossCamera, pose);
    EXPECT_EQ(reported[3].lengthPx, 0.0);
    EXPECT_EQ(reported[3].information.norm(), 0.0);
}

/// The rows of the information are derivatives, compared here with finite differences of projections.
TEST(BranchInformation, AgreesWithDifferencesOfProjections)
{
    const Eigen::Vector3d from(10.0, 5.0, 720.0);
    const Eigen::Vector3d to(10.4, 5.3, 721.0);
    const Eigen::Vector3d center(-3.0, 8.0, 750.0);
    const Matrix6d information = segmentInformation(crossCamera, from, to, center);
    const Eigen::Vector2d along = *project(crossCamera, to) - *project(crossCamera, from);
    const Eigen::Vector2d normal = Eigen::Vector2d(-along.y(), along.x()).normalized();
    const Eigen::Vector3d middle = 0.5 * (from + to);
    for (int k = 0; k < 6; ++k) {
        Vector6d step = Vector6d::Zero();
        step[k] = 1e-5;
        const auto movedBy = [&](double sign) {
            const Eigen::Matrix3d turn = expSo3(sign * step.head<3>());
            return normal.dot(*project(crossCamera, turn * (middle - center) + center + sign * step.tail<3>()));
        };
        const double derivative = (movedBy(1.0) - movedBy(-1.0)) / 2e-5;
        EXPECT_NEAR(information(k, k), along.norm() * derivative * derivative, 1e-4 * (1.0 + information(k, k))) << k;
    }
}

TEST(BranchInformation, NamesTheBranchThatPinsAStep)
{
    const auto reported = branchInformation(cross(), crossCamera, pose);
    EXPECT_EQ(bestBranchesForComponent(reported, 3, prior, 1), std::vector{2});   // horizontally: the vertical vessel
    EXPECT_EQ(bestBranchesForComponent(reported, 4, prior, 1), std::vector{1});
    const auto outside = bestBranchesForComponent(reported, 5, prior, 4);
    EXPECT_EQ(std::ranges::count(outside, 4), 0);
}

TEST(BranchInformation, ChoosesFewBranchesThatTellNearlyAsMuchAsAll)
{
    const auto reported = branchInformation(cross(), crossCamera, pose);
    const auto chosen = informativeBranchSet(reported, prior, 1.3);
    ASSERT_EQ(chosen.size(), 2u);   // the two long ones
    EXPECT_TRUE(std::ranges::count(chosen, 1) == 1 && std::ranges::count(chosen, 2) == 1);
    const Vector6d all = expectedStd(reported, {1, 2, 3, 4}, prior);
    const Vector6d few = expectedStd(reported, chosen, prior);
    EXPECT_TRUE((few.array() <= 1.3 * all.array()).all());
    EXPECT_TRUE((few.array() >= all.array() - 1e-12).all());
    EXPECT_TRUE((expectedStd(reported, {}, prior) - prior).norm() < 1e-9);
}

}   // namespace
