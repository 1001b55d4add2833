#include "core/evaluation/trial/projection_error.h"

#include "core/support/random.h"

#include <gtest/gtest.h>
#include <cmath>
#include <numbers>

using namespace angiopose;

namespace {

using namespace core;

const ProjectionCamera errorCamera{-1877.0, 1877.0, 255.5, 255.5, 512, 512};

RigidTransform poseAtDepth(double depthMm)
{
    return {expSo3(Eigen::Vector3d(0.3, -0.2, 0.1)), Eigen::Vector3d(2.0, -3.0, depthMm)};
}

VesselTree scatteredTree()
{
    CounterRandom random(31);
    VesselTree tree;
    for (int b = 0; b < 3; ++b) {
        VesselBranch branch{b, "", {}, {}};
        for (int i = 0; i < 40; ++i) {
            branch.pointsInPatient.emplace_back(30.0 * random.normal(), 30.0 * random.normal(), 30.0 * random.normal());
        }
        tree.branches.push_back(branch);
    }
    return tree;
}

TEST(ProjectionError, IsZeroForTheTruth)
{
    const VesselTree tree = scatteredTree();
    const PosePair poses{poseAtDepth(800.0), poseAtDepth(800.0)};
    const ProjectionError error = projectionError(tree, errorCamera, poses);
    EXPECT_EQ(error.meanPx, 0.0);
    EXPECT_EQ(error.p95Mm, 0.0);
    EXPECT_EQ(targetError(targetsOf(tree), poses).mtreMm, 0.0);
    EXPECT_LT(poseError(Eigen::Vector3d::Zero(), poses).seedDistanceMm, 1e-12);
}

TEST(ProjectionError, AFlatTreeShiftedSidewaysMovesByFocalLengthOverDepth)
{
    VesselTree flat;
    flat.branches.push_back({0, "", {{0.0, 0.0, 0.0}, {10.0, 0.0, 0.0}, {10.0, 20.0, 0.0}}, {}});
    RigidTransform truth;
    truth.translation = {0.0, 0.0, 800.0};
    RigidTransform shifted = truth;
    shifted.translation.x() += 2.0;
    const ProjectionError error = projectionError(flat, errorCamera, {shifted, truth});
    EXPECT_NEAR(error.meanPx, 1877.0 * 2.0 / 800.0, 1e-10);
    EXPECT_NEAR(error.rmsPx, error.meanPx, 1e-10);
    EXPECT_NEAR(error.p95Px, error.meanPx, 1e-10);
    EXPECT_NEAR(error.meanMm, 2.0, 1e-10);
    EXPECT_NEAR(error.medianMm, 2.0, 1e-10);
}

TEST(ProjectionError, RanksAndMeansFollowTheirDefinitions)
{
    VesselTree tree;
    tree.branches.push_back({0, "", {{0.0, 0.0, 0.0}, {0.0, 0.0, 100.0}, {0.0, 0.0, 200.0}}, {}});
    RigidTransform truth;
    truth.translation = {0.0, 0.0, 800.0};
    RigidTransform shifted = truth;
    shifted.translation.y() += 1.0;
    const double far = 1877.0 / 1000.0;
    const double middle = 1877.0 / 900.0;
    const double near = 1877.0 / 800.0;
    const ProjectionError error = projectionError(tree, errorCamera, {shifted, truth});
    EXPECT_NEAR(error.medianPx, middle, 1e-10);
    EXPECT_NEAR(error.p75Px, 0.5 * (middle + near), 1e-10);
    EXPECT_NEAR(error.p95Px, 0.1 * middle + 0.9 * near, 1e-10);
    EXPECT_NEAR(error.rmsPx, std::sqrt((far * far + middle * middle + near * near) / 3.0), 1e-10);
}

TEST(ProjectionError, PointsThrownBehindTheSourceCostInfinity)
{
    const VesselTree tree = scatteredTree();
    const ProjectionError error = projectionError(tree, errorCamera, {poseAtDepth(-800.0), poseAtDepth(800.0)});
    EXPECT_TRUE(std::isinf(error.meanPx));
    EXPECT_TRUE(std::isinf(error.medianPx));
}

TEST(TargetError, CountsEveryPointAndTheCornersOfTheirBox)
{
    VesselTree tree;
    tree.branches.push_back({0, "", {{1.0, 2.0, 3.0}, {-4.0, 5.0, 6.0}}, {}});
    const std::vector<Eigen::Vector3d> targets = targetsOf(tree);
    ASSERT_EQ(targets.size(), 10u);
    EXPECT_EQ(targets[2], Eigen::Vector3d(-4.0, 2.0, 3.0));
    EXPECT_EQ(targets[9], Eigen::Vector3d(1.0, 5.0, 6.0));
}

TEST(TargetError, ReprojectionDistanceIgnoresDepthAlongTheRay)
{
    // One target point, displaced along its own ray; no rigid pose does this to many target points at once.
    const RigidTransform truth = poseAtDepth(800.0);
    for (const Eigen::Vector3d& target : targetsOf(scatteredTree())) {
        RigidTransform deeper = truth;
        deeper.translation += 0.05 * (truth * target);
        const TargetError error = targetError({target}, {deeper, truth});
        EXPECT_LT(error.mrpdMm, 1e-10);
        EXPECT_GT(error.mtreMm, 30.0);
    }
}

TEST(TargetError, ReprojectionDistanceSeesAShiftAcrossTheRay)
{
    RigidTransform truth;
    truth.translation = {0.0, 0.0, 800.0};
    RigidTransform shifted = truth;
    shifted.translation.x() += 3.0;
    const TargetError error = targetError({Eigen::Vector3d::Zero()}, {shifted, truth});
    EXPECT_NEAR(error.mtreMm, 3.0, 1e-12);
    EXPECT_NEAR(error.mtreInPlaneMm, 3.0, 1e-12);
    EXPECT_NEAR(error.mrpdMm, 800.0 * std::sin(std::atan2(3.0, 800.0)), 1e-9);
}

TEST(PoseError, SplitsRotationAndShiftByTheDetectorPlane)
{
    const Eigen::Vector3d centroid(10.0, -20.0, 5.0);
    const RigidTransform truth = poseAtDepth(800.0);
    const Eigen::Vector3d omega(0.003, 0.004, -0.012);
    RigidTransform estimate;
    estimate.rotation = expSo3(omega) * truth.rotation;
    estimate.translation = truth * centroid + Eigen::Vector3d(3.0, 4.0, -12.0) - estimate.rotation * centroid;
    const PoseError error = poseError(centroid, {estimate, truth});
    const double degrees = 180.0 / std::numbers::pi;
    EXPECT_NEAR(error.angleDeg, 0.013 * degrees, 1e-10);
    EXPECT_NEAR(error.outOfPlaneDeg, 0.005 * degrees, 1e-10);
    EXPECT_NEAR(error.inPlaneDeg, -0.012 * degrees, 1e-10);
    EXPECT_NEAR(error.centroidMm, 13.0, 1e-10);
    EXPECT_NEAR(error.centroidInPlaneMm, 5.0, 1e-10);
    EXPECT_NEAR(error.centroidDepthMm, -12.0, 1e-10);
}

TEST(PoseError, SeedDistanceIsTheShiftOfTheSourceOnly)
{
    const RigidTransform truth = poseAtDepth(800.0);
    Vector6d rotation = Vector6d::Zero();
    rotation.head<3>() << 0.02, -0.03, 0.01;
    EXPECT_NEAR(poseError(Eigen::Vector3d::Zero(), {expSe3(rotation) * truth, truth}).seedDistanceMm, 0.0, 1e-10);
    Vector6d shift = Vector6d::Zero();
    shift.tail<3>() << 3.0, 4.0, 0.0;
    EXPECT_NEAR(poseError(Eigen::Vector3d::Zero(), {expSe3(shift) * truth, truth}).seedDistanceMm, 5.0, 1e-10);
}

TEST(NormalizedError, CountsStandardDeviations)
{
    Vector6d error = Vector6d::Zero();
    error << 0.0, 0.02, 0.0, 0.0, 0.0, 6.0;
    Vector6d variances = Vector6d::Ones();
    variances(1) = 0.01 * 0.01;
    variances(5) = 2.0 * 2.0;
    EXPECT_NEAR(normalizedErrorSquared(error, variances.asDiagonal()), 4.0 + 9.0, 1e-9);
}

}   // namespace
