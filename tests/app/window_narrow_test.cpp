#include "tests/app/scan_window.h"
#include "ui/slices/window_bar.h"
#include "ui/words/language.h"
#include "ui/words/spoken.h"

#include <QAbstractButton>
#include <QMenu>
#include <QScrollArea>

namespace app {
namespace {

using core::BodyPlane;
using WindowNarrow = test::ScanWindow;

/// Buttons and boxes whose words do not fit into them, or that lie outside what `page` shows across.
QStringList cutOff(ui::SlicesPage& page)
{
    QStringList cut;
    for (const QAbstractButton* button : page.findChildren<QAbstractButton*>()) {
        if (!button->isVisible() || button->text().isEmpty()) {
            continue;
        }
        const int left = button->mapTo(&page, QPoint(0, 0)).x();
        const bool isInside = left >= 0 && left + button->width() <= page.width();
        if (!isInside || button->width() < button->minimumSizeHint().width()) {
            cut << button->text();
        }
    }
    return cut;
}

TEST_F(WindowNarrow, NothingOfTheSlicesPageIsCutOffInAnyLanguage)
{
    ui::SlicesPage& page = w.window.slicesPage();
    for (const QSize size : {QSize(960, 600), QSize(1280, 720), QSize(1700, 1000)}) {   // 200 %, 300 %, 100 %
        w.window.resize(size);
        for (const QString& language : ui::languages()) {
            ui::applyLanguage(language);
            ui::speakAgain();
            QTest::qWait(50);
            EXPECT_EQ(cutOff(page), QStringList()) << size.width() << ' ' << language.toStdString();
        }
    }
    ui::applyLanguage(ui::languages().front());
    ui::speakAgain();
}

TEST_F(WindowNarrow, PresetsWithoutRoomWaitInAMenu)
{
    w.window.resize(960, 600);
    QTest::qWait(50);
    ASSERT_TRUE(w.window.slicesPage().bar().isFolded());
    const auto* menu = w.window.slicesPage().bar().findChild<QMenu*>();
    ASSERT_TRUE(menu);
    model().setWindow({600.0, 200.0});
    menu->actions()[1]->trigger();
    EXPECT_EQ(model().window().width, 2000.0) << menu->actions()[1]->text().toStdString();

    w.window.resize(1700, 1000);
    QTest::qWait(50);
    EXPECT_FALSE(w.window.slicesPage().bar().isFolded());
}

TEST_F(WindowNarrow, ThePanelLiesBelowTheSlicesWhereItHasNoRoomBesideThem)
{
    const auto panelFromSlices = [this] {
        const QPoint panel = w.window.tracing().mapTo(&w.window.slicesPage(), QPoint(0, 0));
        return panel - view(BodyPlane::Axial).mapTo(&w.window.slicesPage(), QPoint(0, 0));
    };
    w.window.resize(1700, 1000);
    QTest::qWait(50);
    EXPECT_GT(panelFromSlices().x(), 200);
    w.window.resize(960, 600);
    QTest::qWait(50);
    EXPECT_LT(panelFromSlices().x(), 20);
    EXPECT_GT(panelFromSlices().y(), 100);
    EXPECT_GT(view(BodyPlane::Axial).width(), 120);
}

}   // namespace
}   // namespace app
