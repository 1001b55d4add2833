#include "ui/views/angiogram_view.h"

#include "tests/support/for_each.h"
#include "tests/ui/overlay_fixture.h"

#include <gtest/gtest.h>
#include <QImage>
#include <QTest>

#include <functional>
#include <ostream>

using namespace angiopose;

namespace {

struct Change {
    const char* name;
    std::function<void(ui::AngiogramView&)> make;
};

std::ostream& operator<<(std::ostream& out, const Change& change)
{
    return out << change.name;
}

core::ImageF slope(float offset)
{
    core::ImageF frame(512, 512);
    test::forEachPixel(512, 512, [&](int x, int y) { frame.at(x, y) = offset + static_cast<float>(x) / 600.0F; });
    return frame;
}

core::RigidTransform movedPose()
{
    core::RigidTransform pose = test::obliquePose();
    pose.translation.x() += 10.0;
    return pose;
}

core::Centerline2d tracedLine()
{
    core::Centerline2d traced;
    traced.curves.resize(1);
    for (int x = 100; x < 400; ++x) {
        traced.curves.front().pointsPx.emplace_back(x, 200.0);
    }
    return traced;
}

/// Every change of the displayed content changes the rendered image; no outdated image is reused.
class AngiogramPicture : public ::testing::TestWithParam<Change> {
protected:
    AngiogramPicture()
    {
        view.resize(640, 480);
        view.setFrame(slope(0.0F));
        view.setWindowLevel(1.0, 0.5);
        view.scene().setTree(test::treeOfDots());
        view.setCamera(test::obliqueCamera(test::Mirror::SeenFromDetector));
        view.setPose(test::obliquePose());
        view.scene().setTracedCenterline(tracedLine());
        view.show();
        EXPECT_TRUE(QTest::qWaitForWindowExposed(&view));
    }
    QImage picture() { return view.grab().toImage(); }

    ui::AngiogramView view;
};

TEST_P(AngiogramPicture, FollowsAChange)
{
    const QImage before = picture();
    ASSERT_EQ(picture(), before);
    GetParam().make(view);
    EXPECT_NE(picture(), before);
}

INSTANTIATE_TEST_SUITE_P(
    Changes, AngiogramPicture,
    ::testing::
        Values(
            Change{"frame", [](ui::AngiogramView& v) { v.setFrame(slope(0.2F)); }},
            Change{"window", [](ui::AngiogramView& v) { v.setWindowLevel(0.5, 0.3); }},
            Change{"inverted", [](ui::AngiogramView& v) { v.scene().setInverted(true); }},
            Change{"pose", [](ui::AngiogramView& v) { v.setPose(movedPose()); }},
            Change{"tree", [](ui::AngiogramView& v) { v.scene().setTree({}); }},
            Change{"marks",
                   [](ui::AngiogramView& v) {
                       v.scene().setMarks({{}, {1, 2, 3}, {}, {}, {}});
                   }},
            Change{"mode", [](ui::AngiogramView& v) { v.scene().setMode(ui::OverlayMode::Hidden); }},
            Change{"veil", [](ui::AngiogramView& v) { v.scene().setOverlayHidden(true); }},
            Change{"opacity", [](ui::AngiogramView& v) { v.scene().setOpacity(0.2); }},
            Change{"line width", [](ui::AngiogramView& v) { v.setLineWidth(6.0); }},
            Change{"depth cue", [](ui::AngiogramView& v) { v.scene().setDepthCue(ui::DepthCue::NearBright); }},
            Change{"traced", [](ui::AngiogramView& v) { v.scene().showTracedCenterline(true); }},
            Change{
                "residuals",
                [](ui::AngiogramView& v) {
                    v.scene().setResiduals({{1, {9.0, 9.0}}}, 1.0);
                }},
            Change{"cutout", [](ui::AngiogramView& v) { v.setCutout(ui::Cutout::Shape::RightOf); }},
            Change{"zoom", [](ui::AngiogramView& v) { v.showPart({100.0, 200.0, 100.0, 200.0}); }},
            Change{"from source", [](ui::AngiogramView& v) { v.setFromSource(true); }}));

}   // namespace
