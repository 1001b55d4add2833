#include "core/tracing/angiogram/run/suggest_frame.h"
#include "core/tracing/angiogram/trace_angiogram.h"
#include "io/angiogram_file.h"
#include "tests/support/centerline_dice.h"
#include "tests/support/test_data.h"

#include <gtest/gtest.h>
#include <algorithm>

using namespace angiopose;

namespace {

using core::Curve2d;

core::Angiogram read(const std::string& relative)
{
    auto angiogram = io::readAngiogram(test::dataFile(relative).string());
    EXPECT_TRUE(angiogram) << angiogram.error().message;
    return std::move(angiogram).value();
}

TEST(RealAngiogramTracing, AgreesWithTheAnnotatedCoronaries)
{
    const std::string folder = "coronary-angiograms-with-masks/training/";
    ANGIOPOSE_NEEDS_DATA(folder);
    double sum = 0.0;
    for (int number = 1; number <= 40; ++number) {
        const core::Angiogram angiogram = read(folder + std::to_string(number) + ".png");
        const core::Angiogram truth = read(folder + std::to_string(number) + "_gt.png");
        const auto trace = core::traceAngiogram(angiogram.frames.front(), core::Polarity::VesselsDark);
        ASSERT_TRUE(trace) << number << ": " << trace.error().message;
        const double dice =
            test::centerlineDice(trace.value().centerline, test::whitePixels(truth.frames.front())).dice();
        EXPECT_GT(dice, 0.65) << number;
        sum += dice;
    }
    EXPECT_GT(sum / 40.0, 0.85);
}

class PhantomView : public testing::TestWithParam<const char*> {};

TEST_P(PhantomView, ShowsLongVesselsAndNoBorder)
{
    const std::string file = std::string("coronary-phantom-xa/views-A/") + GetParam();
    ANGIOPOSE_NEEDS_DATA(file);
    const core::Angiogram run = read(file);
    const int suggested = core::suggestFrame(run.frames, run.polarity);
    EXPECT_GT(suggested, 0) << "the first frame is noisy and not yet averaged";
    const auto trace = core::traceAngiogram(run.frames[static_cast<std::size_t>(suggested)], run.polarity);
    ASSERT_TRUE(trace) << trace.error().message;
    double length = 0.0;
    double longest = 0.0;
    for (const Curve2d& curve : trace.value().centerline.curves) {
        length += curve.lengthPx();
        longest = std::max(longest, curve.lengthPx());
        for (const Eigen::Vector2d& point : curve.pointsPx) {
            EXPECT_GT(std::min(point.x(), point.y()), 35.0);
            EXPECT_LT(std::max(point.x(), point.y()), 477.0);
        }
    }
    EXPECT_GT(length, 1000.0);
    EXPECT_GT(longest, 200.0);
    EXPECT_LE(trace.value().centerline.curves.size(), 15U) << "vessels, and walls of the box that they hang in";
}

TEST(RealAngiogramTracing, TellsOfFramesWithoutContrast)
{
    ANGIOPOSE_NEEDS_DATA("coronary-phantom-xa/views-A");
    for (const char* name : {"IM1.dcm", "IM2.dcm", "IM3.dcm", "IM4.dcm"}) {
        const auto run = io::readAngiogram(test::dataFile(std::string("coronary-phantom-xa/views-A/") + name).string());
        ASSERT_TRUE(run) << run.error().message;
        const auto first = core::traceFrame(run.value(), 0);
        ASSERT_TRUE(first);
        EXPECT_FALSE(first.value().warnings.empty()) << name;
        const auto peak = core::traceFrame(run.value(), run.value().suggestedFrame);
        ASSERT_TRUE(peak);
        EXPECT_TRUE(peak.value().warnings.empty()) << name;
    }
}

TEST(RealAngiogramTracing, KeepsAWideTubeThatStandsAlone)
{
    const std::string file = "coronary-phantom-xa/views-A/IM4.dcm";
    ANGIOPOSE_NEEDS_DATA(file);
    const core::Angiogram run = read(file);
    const auto trace = core::traceAngiogram(run.frames[5], run.polarity);
    ASSERT_TRUE(trace) << trace.error().message;
    const Eigen::Vector2d insideTubePx(336.2, 432.5);
    double nearest = 1e9;
    double radius = 0.0;
    for (const Curve2d& curve : trace.value().centerline.curves) {
        for (std::size_t i = 0; i < curve.pointsPx.size(); ++i) {
            const double distance = (curve.pointsPx[i] - insideTubePx).norm();
            radius = distance < nearest ? curve.radiusPx[i] : radius;
            nearest = std::min(nearest, distance);
        }
    }
    EXPECT_LT(nearest, 2.0);
    EXPECT_GT(radius, 3.5);
}

INSTANTIATE_TEST_SUITE_P(AllViews, PhantomView, testing::Values("IM1.dcm", "IM2.dcm", "IM3.dcm", "IM4.dcm"),
                         [](const auto& view) { return std::string(view.param, 3); });

}   // namespace
