#include "core/imaging/display_range.h"
#include "tests/app/open_window.h"
#include "tests/support/for_each.h"
#include "ui/theme/theme.h"

namespace angiopose::app {
namespace {

using test::OpenWindow;
using test::SampleWindow;

QImage grabbed(OpenWindow& w)
{
    QApplication::processEvents();
    return w.window.angiogramView().grab().toImage();
}

int differentPixels(const QImage& a, const QImage& b)
{
    int count = 0;
    test::forEachPixel(std::min(a.width(), b.width()), std::min(a.height(), b.height()),
                       [&](int x, int y) { count += a.pixel(x, y) != b.pixel(x, y) ? 1 : 0; });
    return count;
}

TEST(WindowLook, ShowsARadiographOfTheVesselsThatFollowsThePose)
{
    SampleWindow w;
    for (int press = 0; press < 3; ++press) {   // outline, tube, DRR
        w.press(Qt::Key_O);
    }
    QTest::keyPress(&w.window.angiogramView(), Qt::Key_H);
    const QImage bare = grabbed(w);
    QTest::keyRelease(&w.window.angiogramView(), Qt::Key_H);
    EXPECT_TRUE(test::waitFor([&] { return differentPixels(grabbed(w), bare) > 1000; }));
    const QImage atStart = grabbed(w);

    w.press(Qt::Key_N);
    for (int press = 0; press < 3; ++press) {
        w.press(Qt::Key_Right, Qt::ShiftModifier);   // 30 mm
    }
    w.press(Qt::Key_N);
    EXPECT_TRUE(test::waitFor([&] { return differentPixels(grabbed(w), atStart) > 1000; }));

    w.press(Qt::Key_O);   // back to centerlines
    EXPECT_TRUE(test::waitFor(
        [&] { return w.window.angiogramView().scene().treeIntersects(w.window.angiogramView().scene().viewRect()); }));
}

TEST(WindowLook, HasBrightnessPresets)
{
    SampleWindow w;
    ui::AngiogramView& view = w.window.angiogramView();
    w.press(Qt::Key_0, Qt::ControlModifier);
    const core::DisplayRange vessels = core::vesselRange(view.scene().frame(), w.current().shown().angiogram->polarity);
    EXPECT_NEAR(view.shownRange().low, vessels.low, 1e-6 * vessels.window());
    EXPECT_NEAR(view.shownRange().high, vessels.high, 1e-6 * vessels.window());
    w.press(Qt::Key_0);
    const double automatic = view.shownRange().window();
    w.press(Qt::Key_9, Qt::ControlModifier);
    EXPECT_NEAR(view.shownRange().window(), 1.8 * automatic, 1e-6 * automatic);
}

TEST(WindowLook, TakesWindowAndLevelAsNumbers)
{
    SampleWindow w;
    ui::AngiogramView& view = w.window.angiogramView();
    w.window.angiogramPanel().setFolded(false);
    const auto fields = w.window.angiogramPanel().findChildren<ui::NumberField*>();
    ASSERT_EQ(fields[0]->accessibleName(), QStringLiteral("Window"));
    ASSERT_EQ(fields[1]->accessibleName(), QStringLiteral("Level"));
    EXPECT_NEAR(*fields[0]->value(), view.shownRange().window(), 1e-6);
    const double levelBefore = view.shownRange().level();
    fields[0]->setFocus();
    fields[0]->selectAll();
    QTest::keyClicks(fields[0], QStringLiteral("640"));
    QTest::keyClick(fields[0], Qt::Key_Return);
    EXPECT_NEAR(view.shownRange().window(), 640.0, 1e-9);
    EXPECT_NEAR(view.shownRange().level(), levelBefore, 1e-6);
    w.press(Qt::Key_8);   // the displayed values follow the keys
    EXPECT_NEAR(*fields[0]->value(), 320.0, 1e-9);
}

TEST(WindowLook, RemembersTheColorsOfVesselsAndResiduals)
{
    {
        SampleWindow w;
        const QImage before = grabbed(w);
        w.window.actions()[ui::Command::ColorsBrightness]->trigger();
        EXPECT_EQ(ui::colorScheme(), ui::ColorScheme::Brightness);
        EXPECT_GT(differentPixels(grabbed(w), before), 100);
    }
    {
        OpenWindow again;
        EXPECT_TRUE(again.window.actions()[ui::Command::ColorsBrightness]->isChecked());
        again.window.actions()[ui::Command::ColorsBlueAmber]->trigger();
    }
    EXPECT_EQ(ui::colorScheme(), ui::ColorScheme::BlueAmber);
}

}   // namespace
}   // namespace angiopose::app
