#include "tests/app/scan_window.h"
#include "ui/panels/header_bar.h"
#include "ui/slices/window_bar.h"
#include "ui/words/language.h"
#include "ui/words/retranslation.h"

#include <QAbstractButton>
#include <QMenu>
#include <QScrollArea>

namespace angiopose::app {
namespace {

using core::BodyPlane;
using WindowNarrow = test::ScanWindow;

/// Buttons and combo boxes whose text does not fit, or that extend beyond the visible width of `page`.
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
            ui::retranslate();
            const bool fits = QTest::qWaitFor([&page] { return cutOff(page).isEmpty(); });   // the layout takes time
            EXPECT_TRUE(fits) << size.width() << ' ' << language.toStdString() << ": "
                              << cutOff(page).join(QStringLiteral(", ")).toStdString();
        }
    }
    ui::applyLanguage(ui::languages().front());
    ui::retranslate();
}

TEST(HeaderBar, MenusWithoutRoomHaveAVisibleButton)
{
    ui::HeaderBar header;
    for (int i = 0; i < 12; ++i) {
        header.menuBar()->addMenu(QStringLiteral("A menu of some width"));
    }
    header.resize(600, header.sizeHint().height());
    header.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&header));
    const auto* rest = header.findChild<QAbstractButton*>(QStringLiteral("qt_menubar_ext_button"));
    ASSERT_TRUE(rest);
    EXPECT_TRUE(rest->isVisible());
    EXPECT_EQ(rest->text(), QStringLiteral("»"));
    EXPECT_LE(rest->fontMetrics().horizontalAdvance(rest->text()), rest->width());
    EXPECT_FALSE(rest->toolTip().isEmpty());
}

TEST_F(WindowNarrow, PresetsWithoutRoomWaitInAMenu)
{
    w.window.resize(960, 600);
    const ui::WindowBar& bar = w.window.slicesPage().bar();
    ASSERT_TRUE(QTest::qWaitFor([&bar] { return bar.isFolded(); }));
    const auto* menu = w.window.slicesPage().bar().findChild<QMenu*>();
    ASSERT_TRUE(menu);
    model().setWindow({600.0, 200.0});
    menu->actions()[1]->trigger();
    EXPECT_EQ(model().window().width, 2000.0) << menu->actions()[1]->text().toStdString();

    w.window.resize(1700, 1000);
    EXPECT_TRUE(QTest::qWaitFor([&bar] { return !bar.isFolded(); }));
}

TEST_F(WindowNarrow, ThePanelLiesBelowTheSlicesWhereItHasNoRoomBesideThem)
{
    const auto panelFromSlices = [this] {
        const QPoint panel = w.window.tracing().mapTo(&w.window.slicesPage(), QPoint(0, 0));
        return panel - view(BodyPlane::Axial).mapTo(&w.window.slicesPage(), QPoint(0, 0));
    };
    w.window.resize(1700, 1000);
    EXPECT_TRUE(QTest::qWaitFor([&] { return panelFromSlices().x() > 200; }));
    w.window.resize(960, 600);
    EXPECT_TRUE(QTest::qWaitFor([&] { return panelFromSlices().x() < 20; }));
    EXPECT_GT(panelFromSlices().y(), 100);
    EXPECT_GT(view(BodyPlane::Axial).width(), 120);
}

}   // namespace
}   // namespace angiopose::app
