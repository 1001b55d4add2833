// The short version of tests/benchmark/renderer_agreement_table.cpp: the case with the sharpest curves.
#include "tests/ui/renderer_agreement.h"

#include "ui/views/gl_driver.h"

#include <gtest/gtest.h>

using namespace angiopose;

namespace {

class RenderersAgree : public ::testing::Test {
protected:
    void SetUp() override { ASSERT_TRUE(gl_.isReady()); }

    ui::GlOverlay gl_;
};

TEST_F(RenderersAgree, InLinesAndColors)
{
    for (const test::OverlayState& state : test::overlayStates(2)) {
        for (const double scale : {1.0, 2.0}) {
            const test::Agreement agreement = test::agreementOf(state, gl_, static_cast<int>(512.0 * scale), scale);
            EXPECT_GT(agreement.lineSamples, 40U) << state.name;
            EXPECT_LT(agreement.lineShiftPx, 0.1) << state.name << " at " << agreement.worstLineAt.transpose();
            EXPECT_LE(agreement.grayDifference, 3) << state.name << " at " << agreement.worstGrayAt.transpose();
            EXPECT_LT(agreement.edgeShare, 0.3) << state.name;
        }
    }
}

TEST_F(RenderersAgree, AndAProjectionBesideThePointIsSeen)
{
    const test::OverlayState state = test::overlayStates(2).front();
    const test::Agreement agreement = test::agreementOf(state, gl_, 512, 1.0, [](ui::OverlayScene& scene) {
        core::ProjectionCamera camera = scene.content().camera;
        camera.cx += 0.2;
        scene.setCamera(camera);
    });
    EXPECT_GT(agreement.lineShiftPx, 0.1);
}

TEST_F(RenderersAgree, AndAPoseHandsNothingNewToOpenGl)
{
    ui::OverlayScene scene;
    test::overlayStates(1).front().apply(scene);
    std::vector<std::uint32_t> pixels(64 * 64);
    gl_.draw(scene, false, {}, {pixels.data(), 64, 64});
    const std::uint64_t lines = scene.content().linesRevision;
    core::RigidTransform pose = scene.content().cameraFromPatient;
    pose.translation.x() += 5.0;
    scene.setPose(pose);
    EXPECT_EQ(scene.content().linesRevision, lines);
}

TEST(GlDriver, IsAcceleratedUnlessItDrawsByTheProcessor)
{
    EXPECT_TRUE((ui::GlDriver{"NVIDIA Corporation", "NVIDIA RTX A2000/PCIe/SSE2", "4.6"}.isAccelerated()));
    EXPECT_TRUE((ui::GlDriver{"Intel", "Mesa Intel(R) UHD Graphics 620", "4.6"}.isAccelerated()));
    EXPECT_FALSE((ui::GlDriver{"Mesa/X.org", "llvmpipe (LLVM 15.0.6, 256 bits)", "4.5"}.isAccelerated()));
    EXPECT_FALSE((ui::GlDriver{"VMware, Inc.", "softpipe", "3.3"}.isAccelerated()));
    EXPECT_FALSE((ui::GlDriver{"Google", "Google SwiftShader", "4.5"}.isAccelerated()));
    EXPECT_FALSE((ui::GlDriver{}.isAccelerated()));
}

}   // namespace
