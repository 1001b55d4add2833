#include "core/tracing/angiogram/frame/widest_vessel.h"

#include "core/tracing/angiogram/trace_angiogram.h"
#include "tests/support/drawn_vessels.h"

#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>

using namespace angiopose;

namespace {

core::CArm cArmOf(double spacingMm, double sidMm, double sodMm)
{
    core::CArm cArm;
    cArm.columnSpacingMm = {spacingMm, core::Origin::Header, {}};
    cArm.rowSpacingMm = cArm.columnSpacingMm;
    cArm.sourceToDetectorMm = {sidMm, core::Origin::Header, {}};
    cArm.sourceToIsocenterMm = {sodMm, core::Origin::Header, {}};
    return cArm;
}

TEST(WidestVessel, FollowsPixelSpacingAndMagnification)
{
    EXPECT_DOUBLE_EQ(core::widestVesselRadiusPx({}, 512, 512), 8.0);
    EXPECT_NEAR(core::widestVesselRadiusPx(cArmOf(0.184, 1050, 750), 512, 512), 2.5 * 1.4 / 0.184, 1e-9);
    EXPECT_NEAR(core::widestVesselRadiusPx(cArmOf(0.184, 1050, 750), 1024, 1024), 0.5 * 2.5 * 1.4 / 0.184, 1e-9);
    EXPECT_DOUBLE_EQ(core::widestVesselRadiusPx(cArmOf(0.4, 900, 750), 512, 512), 8.0) << "no less than before";
    EXPECT_DOUBLE_EQ(core::widestVesselRadiusPx(cArmOf(0.05, 1200, 600), 512, 512), 24.0);
    EXPECT_DOUBLE_EQ(core::resolveOptions({}, cArmOf(0.25, 1200, 1000), 512, 512).maxVesselRadiusPx, 12.0);
    EXPECT_DOUBLE_EQ(
        core::resolveOptions({.maxVesselRadiusPx = 5.0}, cArmOf(0.25, 1200, 1000), 512, 512).maxVesselRadiusPx, 5.0)
        << "as somebody wants it";
}

/// A left main artery of 5 mm, which is 36 px wide in this geometry, is traced as one curve of that width.
TEST(WidestVessel, AWideLeftMainIsTracedAlongItsMiddle)
{
    const test::Path trunk = test::circle({256, -100}, 400.0);   // across the whole image
    core::Angiogram run;
    run.frames = {test::drawnFrame(512, 512, {trunk}, 18.0, {.noise = 3.0})};
    run.cArm = cArmOf(0.19, 1050, 750);
    const auto trace = core::traceFrame(run, 0);
    ASSERT_TRUE(trace) << trace.error().message;
    const core::Curve2d& curve =
        *std::ranges::max_element(trace.value().centerline.curves, {}, &core::Curve2d::lengthPx);
    EXPECT_GT(curve.lengthPx(), 420.0);
    for (std::size_t i = 0; i < curve.pointsPx.size(); ++i) {
        if (std::abs(curve.pointsPx[i].x() - 256.0) < 200.0) {
            EXPECT_LT(test::distanceTo(trunk, curve.pointsPx[i]), 2.0) << "a wall is no vessel";
        }
    }
    EXPECT_NEAR(curve.radiusPx[curve.radiusPx.size() / 2], 18.0, 2.7);
}

}   // namespace
