#include "core/measuring/measure_image.h"

#include "core/messages/messages.h"

#include <gtest/gtest.h>
#include <limits>
#include <numbers>

namespace angiopose::core {
namespace {

/// A straight vessel 800 mm from the source, on a detector 1200 mm from it with pixels of 0.4 × 0.2 mm.
struct Seen {
    Seen()
    {
        auto run = std::make_shared<Angiogram>();
        run->frames.emplace_back(512, 512);
        view.angiogram = run;
        view.geometry.cArm.sourceToDetectorMm = {1200.0, Origin::Header, ""};
        view.geometry.cArm.columnSpacingMm = {0.4, Origin::Header, ""};
        view.geometry.cArm.rowSpacingMm = {0.2, Origin::Header, ""};
        view.cameraFromPatient.translation = {0.0, 0.0, 800.0};
        tree.branches.push_back({1, "", {{-10, 0, 0}, {10, 0, 0}}, {}, 0});
    }
    Result<ImageMeasurementResult> measure(MeasurementKind kind, MeasurementPlane plane,
                                           const std::vector<Eigen::Vector2d>& pixels) const
    {
        return measureImage({kind, plane, pixels, 0, ""}, {view, &tree});
    }
    double value(MeasurementKind kind, MeasurementPlane plane, const std::vector<Eigen::Vector2d>& pixels) const
    {
        const auto measured = measure(kind, plane, pixels);
        return measured ? measured.value().value.value : std::numeric_limits<double>::quiet_NaN();
    }
    View view;
    VesselTree tree;
};

using enum MeasurementKind;
constexpr auto atVessels = MeasurementPlane::Vessels;
constexpr auto atDetector = MeasurementPlane::Detector;
constexpr auto inPixels = MeasurementPlane::Pixels;

bool isAmong(const Messages& messages, const MessageEntry& entry)
{
    return std::ranges::any_of(messages, [&entry](const Message& message) { return message.is(entry); });
}

}   // namespace

TEST(MeasureImage, LengthsAreThoseOfThePlaneTheyLieIn)
{
    const Seen seen;
    const std::vector<Eigen::Vector2d> along{{100, 100}, {130, 100}};
    const std::vector<Eigen::Vector2d> down{{100, 100}, {100, 130}};
    EXPECT_NEAR(seen.value(Length, atDetector, along), 12.0, 1e-12);
    EXPECT_NEAR(seen.value(Length, atDetector, down), 6.0, 1e-12);
    EXPECT_NEAR(seen.value(Length, atVessels, along), 12.0 * 800.0 / 1200.0, 1e-12);
    EXPECT_NEAR(seen.value(Length, atVessels, down), 6.0 * 800.0 / 1200.0, 1e-12);
    EXPECT_NEAR(seen.value(Length, inPixels, {{0, 0}, {3, 4}, {3, 14}}), 15.0, 1e-12);
}

TEST(MeasureImage, ALengthAtTheVesselsIsThatOfWhatLiesThere)
{
    const Seen seen;   // contains the vessel, which is 20 mm long
    const auto camera = cameraOf(seen.view).value();
    std::vector<Eigen::Vector2d> ends;
    for (const Eigen::Vector3d& point : seen.tree.branches[0].pointsInPatient) {
        ends.push_back(*project(camera, seen.view.cameraFromPatient * point));
    }
    EXPECT_NEAR(seen.value(Length, atVessels, ends), 20.0, 1e-9);
}

TEST(MeasureImage, AnglesKnowTheShapeOfPixels)
{
    const Seen seen;
    const std::vector<Eigen::Vector2d> pixels{{10, 0}, {0, 0}, {10, 10}};
    EXPECT_NEAR(seen.value(Angle, inPixels, pixels), 45.0, 1e-9);
    EXPECT_NEAR(seen.value(Angle, atVessels, pixels), std::atan2(0.2, 0.4) * 180.0 / std::numbers::pi, 1e-9);
    EXPECT_NEAR(seen.value(Angle, inPixels, {{10, 0}, {0, 0}, {-10, 0}}), 180.0, 1e-9);
    const auto pixelAngle = seen.measure(Angle, inPixels, pixels).value();
    EXPECT_TRUE(isAmong(basisOf(pixelAngle, Angle, {seen.view, &seen.tree}), messages::measureSquarePixels));
}

TEST(MeasureImage, AreasOfOutlinesInEitherSense)
{
    const Seen seen;
    std::vector<Eigen::Vector2d> corner{{0, 0}, {20, 0}, {20, 10}, {10, 10}, {10, 20}, {0, 20}};
    EXPECT_NEAR(seen.value(Area, inPixels, corner), 300.0, 1e-9);
    EXPECT_NEAR(seen.value(Area, atDetector, corner), 300.0 * 0.08, 1e-9);
    std::ranges::reverse(corner);
    EXPECT_NEAR(seen.value(Area, inPixels, corner), 300.0, 1e-9);
}

TEST(MeasureImage, WhatMeansNothingIsSaidNotInvented)
{
    const Seen seen;
    const auto why = [&](MeasurementKind kind, const std::vector<Eigen::Vector2d>& pixels) {
        const auto measured = seen.measure(kind, inPixels, pixels);
        EXPECT_FALSE(measured);
        return measured ? Message::verbatim("a number") : measured.error().message;
    };
    EXPECT_TRUE(why(Area, {{0, 0}, {10, 10}, {10, 0}, {0, 10}}).is(messages::measureSelfIntersecting));
    EXPECT_TRUE(why(Area, {{0, 0}, {10, 10}}).is(messages::measurePoints));
    EXPECT_TRUE(why(Length, {{0, 0}}).is(messages::measurePoints));
    EXPECT_TRUE(why(Angle, {{0, 0}, {0, 0}, {1, 1}}).is(messages::measureAngleDegenerate));
    EXPECT_TRUE(why(Length, {{0, 0}, {std::nan(""), 1}}).is(messages::measureNotFinite));
}

TEST(MeasureImage, WithoutSpacingOrPoseThereAreNoMillimeters)
{
    Seen seen;
    const std::vector<Eigen::Vector2d> line{{0, 0}, {10, 0}};
    EXPECT_EQ(preferredPlane({seen.view, &seen.tree}), atVessels);
    EXPECT_EQ(preferredPlane({seen.view, nullptr}), atDetector);
    seen.view.cameraFromPatient.translation.z() = -800.0;
    EXPECT_TRUE(seen.measure(Length, atVessels, line).error().message.is(messages::measureBehindSource));
    EXPECT_EQ(preferredPlane({seen.view, &seen.tree}), atDetector);
    seen.view.geometry.cArm.rowSpacingMm = {};
    EXPECT_TRUE(seen.measure(Length, atDetector, line).error().message.is(messages::measureNeedsSpacing));
    EXPECT_FALSE(seen.measure(Length, atVessels, line));
    EXPECT_EQ(preferredPlane({seen.view, &seen.tree}), inPixels);
    EXPECT_NEAR(seen.value(Length, inPixels, line), 10.0, 1e-12);
    seen.view.geometry.cArm.rowSpacingMm = {-0.2, Origin::User, ""};
    EXPECT_FALSE(seen.measure(Length, atDetector, line));
}

TEST(MeasureImage, SaysWhereTheScaleComesFrom)
{
    Seen seen;
    const std::vector<Eigen::Vector2d> line{{0, 0}, {10, 0}};
    const auto basis = [&] {
        return basisOf(seen.measure(Length, atVessels, line).value(), Length, {seen.view, &seen.tree});
    };
    EXPECT_TRUE(isAmong(basis(), messages::measureDepthUnchecked)) << "no run found this pose";
    EXPECT_FALSE(isAmong(basis(), messages::measureScaleAssumed));
    seen.view.geometry.cArm.sourceToDetectorMm.origin = Origin::Assumed;
    EXPECT_TRUE(isAmong(basis(), messages::measureScaleAssumed));
    const auto measured = seen.measure(Length, atVessels, line).value();
    EXPECT_EQ(labelOf(measured, Length).text(), "2.7 mm at the vessels (scale assumed)");
    EXPECT_EQ(labelOf(seen.measure(Length, atDetector, line).value(), Length).text(), "4.0 mm at the detector");
    EXPECT_EQ(labelOf(seen.measure(Length, inPixels, line).value(), Length).text(), "10.0 px");

    seen.view.geometry.cArm.sourceToDetectorMm.origin = Origin::User;
    EXPECT_TRUE(isAmong(basis(), messages::measureScaleEntered));
    seen.view.result.emplace();
    seen.view.result->trustworthy = false;
    seen.view.result->uncertainty.depthMm = 8.0;
    EXPECT_TRUE(isAmong(basis(), messages::measurePoseUnreliable));
    const Messages found = basis();
    const auto spread =
        std::ranges::find_if(found, [](const Message& m) { return m.is(messages::measureDepthSpread); });
    ASSERT_NE(spread, found.end());
    EXPECT_EQ(spread->text(), "Depth uncertainty: ±8.0 mm (1-σ), which corresponds to ±1.0 % of the measured length.");
}

TEST(MeasureImage, APoseLookedAtForAWhileHasNoRunBehindIt)
{
    Seen seen;
    seen.view.result.emplace();
    RigidTransform nearer = seen.view.cameraFromPatient;
    nearer.translation.z() = 400.0;
    const MeasurementContext preview{seen.view, &seen.tree, nearer};
    const auto measured = measureImage({Length, atVessels, {{0, 0}, {10, 0}}, 0, ""}, preview).value();
    EXPECT_NEAR(measured.value.value, 10.0 * 0.4 * 400.0 / 1200.0, 1e-12);
    EXPECT_TRUE(isAmong(basisOf(measured, Length, preview), messages::measureDepthUnchecked));
}

TEST(MeasureImage, ATypedScaleHoldsWhereNothingElseIsKnown)
{
    Seen seen;
    const std::vector<Eigen::Vector2d> line{{0, 0}, {30, 40}};
    EXPECT_TRUE(
        seen.measure(Length, MeasurementPlane::Typed, line).error().message.is(messages::measureNeedsEnteredScale));
    seen.view.enteredMmPerPx = 0.2;
    EXPECT_NEAR(seen.value(Length, MeasurementPlane::Typed, line), 10.0, 1e-12);
    EXPECT_NEAR(seen.value(Area, MeasurementPlane::Typed, {{0, 0}, {10, 0}, {10, 10}, {0, 10}}), 4.0, 1e-12);
    EXPECT_EQ(preferredPlane({seen.view, &seen.tree}), atVessels);
    EXPECT_EQ(preferredPlane({seen.view, nullptr}), MeasurementPlane::Typed);
    const auto measured = seen.measure(Length, MeasurementPlane::Typed, line).value();
    EXPECT_EQ(labelOf(measured, Length).text(), "10.0 mm (scale entered)");
    const Messages basis = basisOf(measured, Length, {seen.view, nullptr});
    EXPECT_TRUE(isAmong(basis, messages::measureBasisEntered));
    EXPECT_EQ(basis.size(), 1U);
    seen.view.enteredMmPerPx = -1.0;
    EXPECT_FALSE(seen.measure(Length, MeasurementPlane::Typed, line));
}

}   // namespace angiopose::core
