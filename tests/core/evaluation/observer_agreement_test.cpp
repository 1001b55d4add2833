#include "core/evaluation/own/observer_agreement.h"

#include "core/evaluation/report/observer_report.h"

#include <gtest/gtest.h>
#include <cmath>

using namespace angiopose;
using core::ObserverReading;

namespace {

constexpr std::size_t alongRows = 0;
constexpr std::size_t depth = 2;
constexpr std::size_t roll = 5;

/// A reading whose tree lies `shift` from its position before the trial, rolled about the ray.
ObserverReading reading(const std::string& observer, const std::string& image, const Eigen::Vector3d& shift,
                        double rollDeg = 0.0)
{
    ObserverReading result;
    result.observer = observer;
    result.image = image;
    result.pivotInPatient = {11.0, -7.0, 90.0};
    result.referenceCameraFromPatient = {core::expSo3({0.2, -0.1, 0.4}), {3.0, 4.0, 700.0}};
    const Eigen::Vector3d place = result.referenceCameraFromPatient * result.pivotInPatient + shift;
    const Eigen::Matrix3d turned =
        core::expSo3({0.0, 0.0, rollDeg * M_PI / 180.0}) * result.referenceCameraFromPatient.rotation;
    result.cameraFromPatient = {turned, place - turned * result.pivotInPatient};
    return result;
}

TEST(ObserverAgreement, MeasuresAreTakenAboutTheCentroidFromThePoseBeforeTheTrial)
{
    const auto means = core::observerMeans({reading("ann", "a", {1.0, -2.0, 5.0}, 3.0)});
    ASSERT_EQ(means.size(), 1u);
    EXPECT_NEAR(means[0].mean(0), 1.0, 1e-9);
    EXPECT_NEAR(means[0].mean(1), -2.0, 1e-9);
    EXPECT_NEAR(means[0].mean(depth), 5.0, 1e-9);
    EXPECT_NEAR(means[0].mean(roll), 3.0, 1e-9);
}

TEST(ObserverAgreement, RepeatabilityIsThePooledDeviationWithinAnImage)
{
    // Variances 2 (of 0 and 2) and 8 (of 0 and 4), pooled: 5.
    const auto means = core::observerMeans({reading("ann", "a", {0, 0, 0}), reading("ann", "a", {2, 0, 0}),
                                            reading("ann", "b", {0, 0, 0}), reading("ann", "b", {4, 0, 0}),
                                            reading("ann", "c", {9, 0, 0})});
    const auto found = core::repeatabilityOf(means, "ann", alongRows);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->images, 2);
    EXPECT_EQ(found->readings, 4);
    EXPECT_NEAR(found->withinStd, std::sqrt(5.0), 1e-9);
    EXPECT_NEAR(found->coefficient, 1.96 * std::sqrt(10.0), 1e-9);
    EXPECT_FALSE(core::repeatabilityOf(means, "bob", alongRows));
}

TEST(ObserverAgreement, LimitsOfAgreementAreThoseOfBlandAndAltman)
{
    // Differences 1, 2, 3: bias 2, SD 1.
    const auto means = core::observerMeans({reading("ann", "a", {0, 0, 1}), reading("bob", "a", {0, 0, 0}),
                                            reading("ann", "b", {0, 0, 2}), reading("bob", "b", {0, 0, 0}),
                                            reading("ann", "c", {0, 0, 5}), reading("bob", "c", {0, 0, 2}),
                                            reading("ann", "d", {0, 0, 7})});
    const auto found = core::agreementOf(means, "ann", "bob", depth);
    ASSERT_TRUE(found);
    ASSERT_EQ(found->points.size(), 3u);
    EXPECT_NEAR(found->points[2].x(), 3.5, 1e-9);
    EXPECT_NEAR(found->bias, 2.0, 1e-9);
    EXPECT_NEAR(found->stdDeviation, 1.0, 1e-9);
    EXPECT_NEAR(found->lower(), 0.04, 1e-9);
    EXPECT_NEAR(found->upper(), 3.96, 1e-9);
    EXPECT_NEAR(found->biasError, 1.0 / std::sqrt(3.0), 1e-9);
    EXPECT_NEAR(found->limitError, 1.0, 1e-9);

    const auto betweenStd = core::reproducibilityOf(means, depth);
    ASSERT_TRUE(betweenStd);
    EXPECT_EQ(betweenStd->images, 3);
    EXPECT_NEAR(betweenStd->betweenStd, std::sqrt((0.5 + 2.0 + 4.5) / 3.0), 1e-9);
}

TEST(ObserverAgreement, ReportHoldsWhatTheReadingsAllowAndNothingElse)
{
    EXPECT_TRUE(core::observerTables({reading("ann", "a", {0, 0, 0}), reading("ann", "b", {0, 0, 0})}).empty());
    const std::vector<ObserverReading> both{reading("ann", "a", {0, 0, 1}), reading("bob", "a", {0, 0, 0}),
                                            reading("ann", "b", {0, 0, 2}), reading("bob", "b", {0, 0, 0})};
    const auto tables = core::observerTables(both);
    ASSERT_EQ(tables.size(), 2u);
    EXPECT_EQ(tables[0].id, "observers-between");
    EXPECT_EQ(tables[1].rows.size(), core::poseMeasureCount);
    const auto plots = core::observerPlots(both);
    ASSERT_EQ(plots.size(), core::poseMeasureCount);
    EXPECT_TRUE(plots[0].series[0].isScatter);
    EXPECT_EQ(plots[0].series[0].points.size(), 2u);
}

}   // namespace
