#include "core/registration/pose/landmark_pose.h"

#include "core/geometry/c_arm.h"

#include <gtest/gtest.h>
#include <numbers>
#include <random>

namespace angiopose::core {
namespace {

constexpr ProjectionCamera landmarkCamera{-2500.0, 2500.0, 255.5, 255.5, 512, 512};
const Eigen::Vector3d center(15.0, -180.0, 700.0);

RigidTransform trueCameraFromPatient()
{
    CArm cArm;
    cArm.sourceToIsocenterMm = {750.0, Origin::User, ""};
    cArm.primaryAngleDeg = {-28.0, Origin::User, ""};
    cArm.secondaryAngleDeg = {17.0, Origin::User, ""};
    return cameraFromPatient(cArm, center).value();
}

std::vector<Landmark> pairsOf(const std::vector<Eigen::Vector3d>& offsets, const ProjectionCamera& by = landmarkCamera,
                              double noisePx = 0.0)
{
    std::mt19937_64 random(5);
    std::normal_distribution<double> noise(0.0, 1.0);
    std::vector<Landmark> pairs;
    for (const Eigen::Vector3d& offset : offsets) {
        const Eigen::Vector2d pixel = *project(by, trueCameraFromPatient() * (center + offset).eval());
        pairs.push_back({center + offset, pixel + noisePx * Eigen::Vector2d(noise(random), noise(random)), ""});
    }
    return pairs;
}

const std::vector<Eigen::Vector3d> spreadOffsets{
    {30, 5, -20}, {-25, 12, 10}, {4, -30, 25}, {-8, 22, -31}, {18, -9, 33}};

/// The true pose, rotated and shifted as in manual positioning.
RigidTransform disturbed(double turnDeg, const Eigen::Vector3d& shiftMm)
{
    const RigidTransform truth = trueCameraFromPatient();
    const Eigen::Matrix3d turn =
        expSo3(turnDeg * std::numbers::pi / 180.0 * Eigen::Vector3d(1.0, -2.0, 1.5).normalized());
    const Eigen::Matrix3d rotation = turn * truth.rotation;
    return {rotation, truth * center + shiftMm - rotation * center};
}

double turnDeg(const RigidTransform& a, const RigidTransform& b)
{
    return angleBetween(a.rotation, b.rotation) * 180.0 / std::numbers::pi;
}

}   // namespace

TEST(LandmarkPose, FindsTheExactPoseWithoutAStart)
{
    for (const std::size_t count : {4U, 5U}) {
        const auto found = poseFromLandmarks(
            pairsOf({spreadOffsets.begin(), spreadOffsets.begin() + static_cast<long>(count)}), landmarkCamera, {});
        ASSERT_TRUE(found) << found.error().message.text();
        EXPECT_LT((found.value().cameraFromPatient.matrix() - trueCameraFromPatient().matrix()).norm(), 1e-5);
        EXPECT_LT(found.value().rmsPx, 1e-6);
        EXPECT_FALSE(found.value().usesPrior);
    }
}

TEST(LandmarkPose, NeverMirrorsTheVesselsInAMirroredImage)
{
    ProjectionCamera mirrored = landmarkCamera;
    mirrored.fx = -landmarkCamera.fx;
    const auto found = poseFromLandmarks(pairsOf(spreadOffsets, mirrored), mirrored, {});
    ASSERT_TRUE(found);
    EXPECT_NEAR(found.value().cameraFromPatient.rotation.determinant(), 1.0, 1e-12);
    EXPECT_LT(turnDeg(found.value().cameraFromPatient, trueCameraFromPatient()), 1e-5);
}

TEST(LandmarkPose, NoisyClicksStayWithinTheErrorsItTells)
{
    const auto found = poseFromLandmarks(pairsOf(spreadOffsets, landmarkCamera, 2.0), landmarkCamera, {});
    ASSERT_TRUE(found);
    const LandmarkPose& pose = found.value();
    EXPECT_GT(pose.rmsPx, 0.2);
    EXPECT_LT(pose.rmsPx, 4.0);
    EXPECT_LT(turnDeg(pose.cameraFromPatient, trueCameraFromPatient()), 4.0 * pose.rotationStdDeg);
    const double depthError = (pose.cameraFromPatient * center).z() - 750.0;
    EXPECT_LT(std::abs(depthError), 4.0 * pose.depthStdMm);
    EXPECT_LT(pose.depthStdMm, 60.0);
}

TEST(LandmarkPose, OnePairShiftsThePoseAndTurnsNothing)
{
    const RigidTransform before = disturbed(6.0, {20.0, -14.0, 30.0});
    const auto found = poseFromLandmarks(pairsOf({spreadOffsets[0]}), landmarkCamera, before);
    ASSERT_TRUE(found) << found.error().message.text();
    EXPECT_TRUE(found.value().usesPrior);
    EXPECT_LT(found.value().errorPx[0], 0.1);
    EXPECT_LT(turnDeg(found.value().cameraFromPatient, before), 0.05);
    const Eigen::Vector3d point = center + spreadOffsets[0];
    EXPECT_NEAR((found.value().cameraFromPatient * point).z(), (before * point).z(), 0.5);
}

TEST(LandmarkPose, TwoPairsRollItToo)
{
    const RigidTransform truth = trueCameraFromPatient();
    const Eigen::Matrix3d roll = expSo3(Eigen::Vector3d(0.0, 0.0, 0.4));
    const RigidTransform before{roll * truth.rotation, roll * truth.translation};
    const auto found = poseFromLandmarks(pairsOf({spreadOffsets[0], spreadOffsets[1]}), landmarkCamera, before);
    ASSERT_TRUE(found);
    EXPECT_LT(found.value().rmsPx, 0.5);
    EXPECT_LT(turnDeg(found.value().cameraFromPatient, truth), 2.0);
}

TEST(LandmarkPose, ThreePairsTakeTheSolutionNearTheStart)
{
    const auto found = poseFromLandmarks(pairsOf({spreadOffsets[0], spreadOffsets[1], spreadOffsets[2]}),
                                         landmarkCamera, disturbed(5.0, {5.0, 5.0, 10.0}));
    ASSERT_TRUE(found);
    EXPECT_LT(found.value().rmsPx, 1.0);
    EXPECT_LT(turnDeg(found.value().cameraFromPatient, trueCameraFromPatient()), 8.0);
}

TEST(LandmarkPose, AWrongStartDoesNotKeepItFromTheTruth)
{
    const auto found = poseFromLandmarks(pairsOf(spreadOffsets), landmarkCamera, disturbed(150.0, {40.0, 0.0, 100.0}));
    ASSERT_TRUE(found);
    EXPECT_LT(turnDeg(found.value().cameraFromPatient, trueCameraFromPatient()), 1e-4);
}

TEST(LandmarkPose, SaysWhatDegeneratePairsLack)
{
    const auto messageOf = [](const std::vector<Landmark>& pairs, const std::optional<RigidTransform>& before) {
        const auto found = poseFromLandmarks(pairs, landmarkCamera, before);
        return found ? std::string() : found.error().message.text();
    };
    EXPECT_NE(messageOf({}, trueCameraFromPatient()).find("no landmarks"), std::string::npos);
    EXPECT_NE(messageOf(pairsOf({spreadOffsets[0], spreadOffsets[1], spreadOffsets[2]}), {}).find("four"),
              std::string::npos);
    EXPECT_NE(messageOf(pairsOf({{0, 0, 0}, {10, 5, 2}, {20, 10, 4}, {-10, -5, -2}}), {}).find("line"),
              std::string::npos);
    EXPECT_NE(messageOf(pairsOf({spreadOffsets[0], spreadOffsets[0], spreadOffsets[0], spreadOffsets[0]}), {})
                  .find("same position"),
              std::string::npos);
    std::vector<Landmark> broken = pairsOf(spreadOffsets);
    broken[2].pixel.x() = std::numeric_limits<double>::quiet_NaN();
    EXPECT_NE(messageOf(broken, {}).find("finite"), std::string::npos);
}

}   // namespace angiopose::core
