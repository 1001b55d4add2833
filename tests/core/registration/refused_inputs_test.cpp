#include "core/registration/registration.h"
#include "tests/support/clean_case.h"

#include <gtest/gtest.h>
#include <cmath>
#include <limits>

namespace angiopose::core {
namespace {

TEST(RegisterVessels, FlagsAStraightVessel)
{
    RegistrationInput input;
    input.camera = {-1877.0, 1877.0, 255.5, 255.5, 512, 512};
    input.initialCameraFromPatient.translation = {0.0, 0.0, 800.0};
    VesselBranch branch{1, {}, {}, {}};
    for (int i = 0; i <= 80; ++i) {
        branch.pointsInPatient.emplace_back(i - 40.0, 0.0, 0.0);
    }
    input.tree.branches = {branch};
    input.target = projectTree(input.tree, input.camera, input.initialCameraFromPatient);
    const auto result = registerVessels(input);
    ASSERT_TRUE(result);
    EXPECT_FALSE(result.value().trustworthy);
    EXPECT_FALSE(result.value().uncertainty.observed[0]) << "turning about the vessel shows nothing";
    EXPECT_FALSE(result.value().warnings.empty());
}

TEST(RegisterVessels, FlagsAnImageOfClutter)
{
    const test::CleanCase clean(7);
    RegistrationInput input = clean.from(clean.truth);
    input.target.curves.clear();
    CounterRandom random(8);
    for (int k = 0; k < 6; ++k) {
        Curve2d curve{k, {}, {}};
        const Eigen::Vector2d middle(random.uniform(200.0, 800.0), random.uniform(200.0, 800.0));
        const double radius = random.uniform(20.0, 90.0);
        for (int i = 0; i < 300; ++i) {
            curve.pointsPx.push_back(middle + radius * Eigen::Vector2d(std::cos(i / 50.0), std::sin(i / 50.0)));
        }
        input.target.curves.push_back(curve);
    }
    const auto result = registerVessels(input);
    ASSERT_TRUE(result);
    EXPECT_FALSE(result.value().trustworthy);
}

TEST(RegisterVessels, RecoversOrFlagsAStartOffTheImage)
{
    const test::CleanCase clean(8);
    for (const double shiftMm : {300.0, 3000.0}) {
        RigidTransform start = clean.truth;
        start.translation.x() += shiftMm;
        const auto result = registerVessels(clean.from(start));
        ASSERT_TRUE(result);
        EXPECT_TRUE(meanErrorPx(clean, result.value().cameraFromPatient) < 1.0 || !result.value().trustworthy)
            << shiftMm << " mm";
    }
}

TEST(RegisterVessels, NamesWhatMakesAnInputUnusable)
{
    const test::CleanCase clean(1);
    const RegistrationInput good = clean.from(clean.truth);
    const auto reasonFor = [](const RegistrationInput& input) {
        const auto result = registerVessels(input);
        return result ? std::string("accepted") : result.error().message.text();
    };
    RegistrationInput input = good;
    input.tree.branches.clear();
    EXPECT_NE(reasonFor(input).find("no branches"), std::string::npos);
    input = good;
    input.tree.branches.front().radiusMm.assign(input.tree.branches.front().pointsInPatient.size(), 1.0);
    input.tree.branches.front().radiusMm.back() = -1.0;
    EXPECT_NE(reasonFor(input).find("a radius that is negative"), std::string::npos);
    input = good;
    input.initialCameraFromPatient.translation -=
        input.initialCameraFromPatient * centroidInPatient(input.tree);   // the source inside the vessels
    EXPECT_NE(reasonFor(input).find("at or behind the X-ray source"), std::string::npos);
    input = good;
    input.target.curves.clear();
    EXPECT_NE(reasonFor(input).find("2-D centerline is empty"), std::string::npos);
    input = good;
    input.tree.branches[0].pointsInPatient[0].x() = std::numeric_limits<double>::quiet_NaN();
    EXPECT_NE(reasonFor(input).find("finite"), std::string::npos);
    input = good;
    input.initialCameraFromPatient.translation.z() -= 5000.0;
    EXPECT_NE(reasonFor(input).find("behind the X-ray source"), std::string::npos);
    input = good;
    input.initialCameraFromPatient.rotation *= 1.1;
    EXPECT_NE(reasonFor(input).find("not a rigid transform"), std::string::npos);
    input = good;
    input.auxiliaryBranchIds = {987654};
    EXPECT_NE(reasonFor(input).find("987654"), std::string::npos);
    RegistrationOptions options;
    options.method = "guess";
    const auto result = registerVessels(good, options);
    ASSERT_FALSE(result);
    EXPECT_NE(result.error().message.text().find("no method 'guess'"), std::string::npos);
}

TEST(EvaluatePose, JudgesWithoutMoving)
{
    const test::CleanCase clean(2);
    RigidTransform shifted = clean.truth;
    shifted.translation.x() += 10.0;
    const auto atTruth = evaluatePose(clean.from(clean.truth), clean.truth);
    const auto beside = evaluatePose(clean.from(clean.truth), shifted);
    ASSERT_TRUE(atTruth && beside);
    EXPECT_EQ(beside.value().cameraFromPatient.matrix(), shifted.matrix());
    EXPECT_TRUE(atTruth.value().trustworthy);
    EXPECT_FALSE(beside.value().trustworthy);
    EXPECT_GT(beside.value().metrics.medianPx, 20.0 * atTruth.value().metrics.medianPx);
}

}   // namespace
}   // namespace angiopose::core
