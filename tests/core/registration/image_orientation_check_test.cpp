#include "core/messages/messages.h"
#include "core/registration/registration.h"
#include "tests/support/clean_case.h"

#include <gtest/gtest.h>
#include <algorithm>
#include <functional>

namespace angiopose::core {
namespace {

using Move = std::function<Eigen::Vector2d(const Eigen::Vector2d&)>;

constexpr double lastPixel = 1023.0;   // last column and row of the clean case's images

/// A tree and its image, stored in another orientation by `stored`.
RegistrationInput inputOf(const Move& stored)
{
    const test::CleanCase clean(3);
    RegistrationInput input = clean.fromNearby(4);
    for (Curve2d& curve : input.target.curves) {
        std::ranges::transform(curve.pointsPx, curve.pointsPx.begin(), stored);
    }
    return input;
}

RegistrationResult resultOf(const Move& stored)
{
    return registerVessels(inputOf(stored)).value();
}

Eigen::Vector2d leftToRight(const Eigen::Vector2d& at)
{
    return {lastPixel - at.x(), at.y()};
}

bool isSaid(const RegistrationResult& result, const MessageEntry& message)
{
    return std::ranges::any_of(result.warnings, [&](const Message& each) { return each.is(message); });
}

TEST(ImageOrientationCheck, NamesAMirroredImage)
{
    const auto leftRight = resultOf(leftToRight);
    EXPECT_FALSE(leftRight.trustworthy);
    EXPECT_TRUE(isSaid(leftRight, messages::frameMirroredLeftRight));
    const auto upDown = resultOf([](const Eigen::Vector2d& at) { return Eigen::Vector2d(at.x(), lastPixel - at.y()); });
    EXPECT_FALSE(upDown.trustworthy);
    EXPECT_TRUE(isSaid(upDown, messages::frameMirroredUpDown));
}

TEST(ImageOrientationCheck, NamesAMirroredImageThoughBranchesWereChosen)
{
    RegistrationInput input = inputOf(leftToRight);
    input.auxiliaryBranchIds = {input.tree.branches[1].id};
    const RegistrationResult result = registerVessels(input).value();
    EXPECT_FALSE(result.trustworthy);
    EXPECT_TRUE(isSaid(result, messages::frameMirroredLeftRight));
}

TEST(ImageOrientationCheck, IsStoppedWhereTheFitIsDone)
{
    // After the fit, its last progress report is repeated while the other orientations are checked.
    int last = 0;
    int asked = 0;
    const auto stopAfterTheFit = [&](const IterationReport& report) {
        asked += report.iteration == last ? 1 : 0;
        last = report.iteration;
        return asked > 0 ? ObserverDecision::Stop : ObserverDecision::Continue;
    };
    const RegistrationResult result = registerVessels(inputOf(leftToRight), {}, stopAfterTheFit).value();
    EXPECT_EQ(asked, 1) << "nobody is asked again once stopped";
    EXPECT_EQ(result.stopReason, StopReason::StoppedByUser);
    EXPECT_FALSE(result.trustworthy);
    EXPECT_FALSE(isSaid(result, messages::frameMirroredLeftRight));
}

TEST(ImageOrientationCheck, NamesATurnedImageUnlessItIsFoundTurned)
{
    // Right becomes down: a clockwise turn.
    const auto turned = resultOf([](const Eigen::Vector2d& at) { return Eigen::Vector2d(lastPixel - at.y(), at.x()); });
    EXPECT_TRUE(turned.trustworthy || isSaid(turned, messages::frameTurnedClockwise));
    const auto around =
        resultOf([](const Eigen::Vector2d& at) { return Eigen::Vector2d(lastPixel - at.x(), lastPixel - at.y()); });
    EXPECT_TRUE(around.trustworthy || isSaid(around, messages::frameUpsideDown));
}

/// A patient lying feet first, with a device that counts the angles as if the patient were lying head first.
TEST(ImageOrientationCheck, NamesAnglesCountedFromTheTable)
{
    const TableAngles reading{PatientPosition::FFS, {-10.0, 5.0, 180.0}, patientFromTable(PatientPosition::FFS)};
    RegistrationInput input = inputOf([](const Eigen::Vector2d& at) { return at; });
    const Eigen::Vector3d pivot = centroidInPatient(input.tree);
    input.initialCameraFromPatient =
        input.initialCameraFromPatient * RigidTransform{reading.turn, pivot - reading.turn * pivot};
    const RegistrationResult unknown = registerVessels(input).value();
    EXPECT_FALSE(unknown.trustworthy);
    EXPECT_FALSE(isSaid(unknown, messages::frameAnglesFromTable));
    input.tableAngles = reading;   // the reading is its own inverse
    const RegistrationResult result = registerVessels(input).value();
    EXPECT_FALSE(result.trustworthy);
    ASSERT_TRUE(isSaid(result, messages::frameAnglesFromTable));
    EXPECT_NE(result.warnings.front().text().find("LAO/RAO -10.0°, CRA/CAU 5.0°, roll 180.0°"), std::string::npos)
        << result.warnings.front().text();
}

TEST(ImageOrientationCheck, IsSilentOfAnImageThatFits)
{
    const auto result = resultOf([](const Eigen::Vector2d& at) { return at; });
    EXPECT_TRUE(result.trustworthy);
    EXPECT_TRUE(
        std::ranges::none_of(result.warnings, [](const Message& each) { return each.id().starts_with("frame."); }));
}

}   // namespace
}   // namespace angiopose::core
