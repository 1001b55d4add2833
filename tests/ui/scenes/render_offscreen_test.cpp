#include "ui/scenes/render_offscreen.h"

#include "tests/support/for_each.h"
#include "tests/ui/overlay_fixture.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace angiopose;

namespace {

const ui::ViewRect wholeImage{-0.5, 511.5, -0.5, 511.5};

void fillWithDots(ui::OverlayScene& scene, test::Mirror mirror)
{
    scene.setFrame(core::ImageF(512, 512, 0.0F));
    scene.setWindowLevel(1.0, 0.5);
    scene.setTree(test::treeOfDots());
    scene.setCamera(test::obliqueCamera(mirror));
    scene.setPose(test::obliquePose());
}

double brightnessAt(const core::ColorImage& picture, int x, int y)
{
    const std::size_t at =
        3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) + static_cast<std::size_t>(x));
    return picture.rgb[at] + picture.rgb[at + 1] + picture.rgb[at + 2];
}

class RenderOffscreenOf : public ::testing::TestWithParam<test::Mirror> {};

TEST_P(RenderOffscreenOf, PutsEveryPointWhereTheCameraProjectsIt)
{
    ui::OverlayScene scene;
    fillWithDots(scene, GetParam());
    const auto picture = ui::renderOffscreen(scene, 1024, 1024, wholeImage);
    ASSERT_TRUE(picture) << picture.error().message;
    for (const core::VesselBranch& branch : test::treeOfDots().branches) {
        const auto pixel =
            core::project(test::obliqueCamera(GetParam()), test::obliquePose() * branch.pointsInPatient.front());
        const Eigen::Vector2d expected = 2.0 * (*pixel + Eigen::Vector2d(0.5, 0.5)) - Eigen::Vector2d(0.5, 0.5);
        const auto found =
            test::centerOfLight([&](int x, int y) { return brightnessAt(picture.value(), x, y); }, expected);
        EXPECT_LT((found - expected).norm(), 0.25) << "branch " << branch.id;
    }
}

INSTANTIATE_TEST_SUITE_P(BothMirrors, RenderOffscreenOf,
                         ::testing::Values(test::Mirror::SeenFromDetector, test::Mirror::SeenFromSource));

TEST(RenderOffscreen, ShowsEveryPixelOfTheFrameAsItsGrayValue)
{
    core::ImageF frame(16, 16);
    for (int i = 0; i < 256; ++i) {
        frame.pixels[static_cast<std::size_t>(i)] = static_cast<float>(i);
    }
    ui::OverlayScene scene;
    scene.setFrame(frame);
    scene.setWindowLevel(255.0, 127.5);
    scene.setInterpolation(ui::Interpolation::Nearest);
    const auto picture = ui::renderOffscreen(scene, 16, 16, {-0.5, 15.5, -0.5, 15.5});
    ASSERT_TRUE(picture) << picture.error().message;
    for (std::size_t i = 0; i < 256; ++i) {
        EXPECT_NEAR(picture.value().rgb[3 * i], static_cast<double>(i), 1.0);
    }
}

TEST(RenderOffscreen, HidesPointsBehindTheSource)
{
    ui::OverlayScene scene;
    fillWithDots(scene, test::Mirror::SeenFromDetector);
    core::RigidTransform behind = test::obliquePose();
    behind.translation.z() = -750.0;
    scene.setPose(behind);
    const auto picture = ui::renderOffscreen(scene, 256, 256, wholeImage);
    ASSERT_TRUE(picture) << picture.error().message;
    EXPECT_TRUE(std::all_of(picture.value().rgb.begin(), picture.value().rgb.end(), [](int v) { return v == 0; }));
}

TEST(RenderOffscreen, JoinsBandsWithoutSeam)
{
    core::VesselTree line;
    core::VesselBranch branch;
    branch.id = 1;
    for (int i = 0; i <= 100; ++i) {
        branch.pointsInPatient.emplace_back(0.0, -60.0 + 1.2 * i, 0.0);
    }
    line.branches = {branch};
    ui::OverlayScene scene;
    scene.setTree(line);
    scene.setCamera({2400.0, 2400.0, 255.5, 255.5, 512, 512});
    scene.setPose({Eigen::Matrix3d::Identity(), {0.0, 0.0, 750.0}});
    const auto picture = ui::renderOffscreen(scene, 300, 3000, {230.0, 281.2, -0.5, 511.5});
    ASSERT_TRUE(picture) << picture.error().message;
    const int column = static_cast<int>((255.5 - 230.0) / 51.2 * 300);
    const double inside = brightnessAt(picture.value(), column, 1500);
    EXPECT_GT(inside, 200.0);
    for (int y = 1016; y < 1032; ++y) {   // the border between two bands is at 1024
        EXPECT_NEAR(brightnessAt(picture.value(), column, y), inside, 3.0) << y;
    }
}

TEST(RenderOffscreen, LeavesTheSceneAsItWas)
{
    ui::OverlayScene scene;
    scene.setViewRect({1.0, 2.0, 3.0, 4.0});
    scene.setLineWidthPx(5.0);
    ASSERT_TRUE(ui::renderOffscreen(scene, 64, 64, wholeImage));
    EXPECT_EQ(scene.viewRect(), (ui::ViewRect{1.0, 2.0, 3.0, 4.0}));
    EXPECT_EQ(scene.lineWidthPx(), 5.0);
}

TEST(RenderOffscreen, BurnsTextsIntoTheirCorners)
{
    ui::OverlayScene scene;
    ui::CornerTexts texts;
    texts.bottomRight = {"Not for clinical use"};
    const auto picture = ui::renderOffscreen(scene, 600, 600, wholeImage, texts);
    ASSERT_TRUE(picture) << picture.error().message;
    double topLeft = 0.0;
    double bottomRight = 0.0;
    test::forEachPixel(300, 300, [&](int x, int y) {
        topLeft += brightnessAt(picture.value(), x, y);
        bottomRight += brightnessAt(picture.value(), 599 - x, 599 - y);
    });
    EXPECT_EQ(topLeft, 0.0);
    EXPECT_GT(bottomRight, 10000.0);
}

TEST(RenderOffscreen, RefusesImpossibleSizes)
{
    ui::OverlayScene scene;
    const auto picture = ui::renderOffscreen(scene, 0, 100, wholeImage);
    ASSERT_FALSE(picture);
    EXPECT_NE(picture.error().message.text().find("Choose another size"), std::string::npos);
}

/// Two parallel vessels of 3 mm radius, the upper one closer to the source.
core::VesselTree nearAndFar()
{
    core::VesselTree tree;
    for (const double side : {-1.0, 1.0}) {
        core::VesselBranch branch;
        branch.id = side < 0.0 ? 1 : 2;
        for (int i = 0; i <= 40; ++i) {
            branch.pointsInPatient.emplace_back(-20.0 + i, 20.0 * side, 40.0 * side);
        }
        branch.radiusMm.assign(branch.pointsInPatient.size(), 3.0);
        tree.branches.push_back(branch);
    }
    return tree;
}

double brightestIn(const core::ColorImage& picture, int firstRow, int lastRow)
{
    double brightest = 0.0;
    for (int y = firstRow; y < lastRow; ++y) {
        brightest = std::max(brightest, brightnessAt(picture, 256, y));
    }
    return brightest;
}

TEST(OverlayScene, ShowsNearVesselsBrighterWhenAsked)
{
    ui::OverlayScene scene;
    scene.setTree(nearAndFar());
    scene.setCamera({2400.0, 2400.0, 255.5, 255.5, 512, 512});
    scene.setPose({Eigen::Matrix3d::Identity(), {0.0, 0.0, 750.0}});
    const auto plain = ui::renderOffscreen(scene, 512, 512, wholeImage).value();
    EXPECT_NEAR(brightestIn(plain, 0, 256), brightestIn(plain, 256, 512), 15.0);
    scene.setDepthCue(ui::DepthCue::NearBright);
    const auto cued = ui::renderOffscreen(scene, 512, 512, wholeImage).value();
    EXPECT_GT(brightestIn(cued, 0, 256), 1.5 * brightestIn(cued, 256, 512));
}

TEST(OverlayScene, FillsTubesOnlyInTubeMode)
{
    ui::OverlayScene scene;
    scene.setTree(nearAndFar());
    scene.setCamera({2400.0, 2400.0, 255.5, 255.5, 512, 512});
    scene.setPose({Eigen::Matrix3d::Identity(), {0.0, 0.0, 750.0}});
    // The nearer vessel: center at v = 255.5 − 2400 · 20 / 710 = 187.9, radius 10.1 px; 5 px off the center.
    scene.setMode(ui::OverlayMode::Outline);
    EXPECT_EQ(brightnessAt(ui::renderOffscreen(scene, 512, 512, wholeImage).value(), 256, 193), 0.0);
    scene.setMode(ui::OverlayMode::Tube);
    EXPECT_GT(brightnessAt(ui::renderOffscreen(scene, 512, 512, wholeImage).value(), 256, 193), 60.0);
    const auto extent = scene.extentOf(1);
    ASSERT_TRUE(extent);
    EXPECT_NEAR(extent->top, 187.9, 0.1);
    EXPECT_FALSE(scene.extentOf(99));
}

TEST(OverlayScene, FindsTheBranchUnderAPoint)
{
    ui::OverlayScene scene;
    fillWithDots(scene, test::Mirror::SeenFromDetector);
    const core::VesselBranch branch = test::treeOfDots().branches[4];
    const auto pixel = core::project(test::obliqueCamera(test::Mirror::SeenFromDetector),
                                     test::obliquePose() * branch.pointsInPatient.front());
    EXPECT_EQ(scene.branchAt(*pixel + Eigen::Vector2d(2.0, 0.0), 3.0), branch.id);
    EXPECT_EQ(scene.branchAt(*pixel + Eigen::Vector2d(4.0, 0.0), 3.0), std::nullopt);
    scene.setMode(ui::OverlayMode::Hidden);
    EXPECT_EQ(scene.branchAt(*pixel, 3.0), std::nullopt);
}

}   // namespace
