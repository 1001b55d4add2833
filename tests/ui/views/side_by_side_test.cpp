#include "ui/places/side_by_side.h"

#include "tests/support/for_each.h"
#include "tests/ui/overlay_fixture.h"
#include "ui/views/angiogram_view.h"

#include <gtest/gtest.h>
#include <QSignalSpy>
#include <QTest>

namespace angiopose::ui {
namespace {

QRect placeOf(QWidget& part, QWidget& in)
{
    return {part.mapTo(&in, QPoint()), part.size()};
}

TEST(SideBySide, GivesEachImageRoomOfItsOwn)
{
    auto* shown = new AngiogramView;
    SideBySide images(*shown);
    images.resize(1200, 700);
    images.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&images));
    EXPECT_EQ(images.images().size(), 1U);
    for (const std::size_t count : {1U, 2U, 3U, 5U, 1U}) {
        images.setPaneCount(count);
        QApplication::processEvents();
        std::vector<QRect> places{placeOf(*shown, images)};
        for (std::size_t i = 0; i < count; ++i) {
            places.push_back(placeOf(images.pane(i), images));
            EXPECT_GE(places.back().left(), places.front().right()) << count << ", pane " << i;
        }
        for (std::size_t i = 0; i < places.size(); ++i) {
            EXPECT_GT(places[i].width(), 150) << count << ", image " << i;
            EXPECT_GT(places[i].height(), 150) << count << ", image " << i;
            for (std::size_t k = i + 1; k < places.size(); ++k) {
                EXPECT_FALSE(places[i].intersects(places[k])) << count << ": " << i << ", " << k;
            }
        }
        EXPECT_EQ(images.images().size(), count + 1);
    }
    EXPECT_NEAR(placeOf(*shown, images).width(), images.pane(0).width(), 4) << "two share the room evenly";
    images.setPaneCount(0);
    QApplication::processEvents();
    EXPECT_EQ(placeOf(*shown, images), images.rect());
}

TEST(ViewPane, AsksForFramesWithinTheRun)
{
    ViewPane pane;
    pane.resize(300, 300);
    pane.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&pane));
    pane.image().setFrame(core::ImageF(64, 64, 0.5F));
    pane.showFrame(3, 5);
    const QSignalSpy asked(&pane, &ViewPane::frameRequested);
    QTest::keyClick(&pane.image(), Qt::Key_Down);
    QTest::keyClick(&pane.image(), Qt::Key_Home);
    QTest::keyClick(&pane.image(), Qt::Key_Down, Qt::ShiftModifier);
    ASSERT_EQ(asked.count(), 3);
    EXPECT_EQ(asked[0][0].toInt(), 4);
    EXPECT_EQ(asked[1][0].toInt(), 0);
    EXPECT_EQ(asked[2][0].toInt(), 4) << "the last";
    pane.showFrame(2, 5);
    EXPECT_EQ(asked.count(), 3) << "a notification is not a request";
}

TEST(ViewPane, IsChosenByItsNameOrADoubleClick)
{
    ViewPane pane;
    pane.resize(300, 300);
    pane.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&pane));
    pane.image().setFrame(core::ImageF(64, 64, 0.5F));
    const QSignalSpy viewChosen(&pane, &ViewPane::viewChosen);
    QTest::mouseDClick(&pane.image(), Qt::LeftButton, {}, {100, 100});
    EXPECT_EQ(viewChosen.count(), 1);
    QTest::mouseClick(&pane.title(), Qt::LeftButton);
    EXPECT_EQ(viewChosen.count(), 2);
    QTest::mouseClick(&pane.image(), Qt::LeftButton, {}, {100, 100});
    EXPECT_EQ(viewChosen.count(), 2);
}

int differing(const QImage& a, const QImage& b, const QRect& part)
{
    int count = 0;
    test::forEachPixel({part.left(), part.top()}, {part.right() + 1, part.bottom() + 1},
                       [&](int x, int y) { count += a.pixel(x, y) != b.pixel(x, y) ? 1 : 0; });
    return count;
}

TEST(AngiogramViewCrosshair, LiesWhereTheSegmentIs)
{
    AngiogramView view(ImageRole::Secondary);
    view.resize(400, 400);
    view.setFrame(core::ImageF(100, 100, 0.5F));
    view.setWindowLevel(1.0, 0.5);
    view.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&view));
    const QImage before = view.grab().toImage();
    const double ratio = view.devicePixelRatio();
    view.setCrosshair({core::ImageSegment{{20.0, 40.0}, {80.0, 40.0}}, std::nullopt});
    const QImage after = view.grab().toImage();
    const auto device = [&](double left, double top, double right, double bottom) {
        const QPointF from = view.widgetFromImage({left, top}) * ratio;
        const QPointF to = view.widgetFromImage({right, bottom}) * ratio;
        return QRectF(from, to).toRect();
    };
    EXPECT_GT(differing(before, after, device(21.0, 38.0, 79.0, 42.0)), 200);
    EXPECT_EQ(differing(before, after, device(2.0, 2.0, 98.0, 37.0)), 0);
    EXPECT_EQ(differing(before, after, device(83.0, 38.0, 98.0, 42.0)), 0);
    view.setCrosshair({});
    EXPECT_EQ(view.grab().toImage(), before);
}

TEST(AngiogramViewCrosshair, TakesTheLookButNotWhatIsShown)
{
    AngiogramView leader;
    AngiogramView follower(ImageRole::Secondary);
    leader.setFrame(core::ImageF(8, 8, 1.0F));
    follower.setFrame(core::ImageF(16, 16, 2.0F));
    follower.setCamera(test::obliqueCamera(test::Mirror::SeenFromDetector));
    leader.scene().setOpacity(0.4);
    leader.scene().setInverted(true);
    BranchMarks marks;
    marks.selected = {3};
    leader.scene().setMarks(marks);
    leader.setFromSource(true);
    follower.copyAppearance(leader);
    const OverlayContent& content = follower.scene().content();
    EXPECT_EQ(content.opacity, 0.4);
    EXPECT_TRUE(content.frame.isInverted());
    EXPECT_EQ(content.marks.selected, std::set<int>{3});
    EXPECT_TRUE(follower.isFromSource());
    EXPECT_EQ(content.frame.width(), 16);
    EXPECT_EQ(content.camera, test::obliqueCamera(test::Mirror::SeenFromDetector));
}

}   // namespace
}   // namespace angiopose::ui
