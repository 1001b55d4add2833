#include "ui/panels/view_strip.h"

#include <gtest/gtest.h>
#include <QListWidget>
#include <QScrollBar>
#include <QTest>

namespace angiopose::ui {
namespace {

TEST(ViewStrip, ManyViewsInANarrowStripAreAllSeen)
{
    ViewStrip strip;
    const ViewRow line{QStringLiteral("LAO 30 with a name that is rather long\n0.50 mm · 1.2 px"),
                       QStringLiteral("tip")};
    strip.showViews({line, line, line, line}, 0);
    strip.showSideBySide(true);
    auto& list = *strip.findChild<QListWidget*>();
    for (const int widthPx : {350, 500, 900}) {
        strip.resize(widthPx, strip.sizeHint().height());
        strip.show();
        QTest::qWait(50);
        EXPECT_EQ(list.horizontalScrollBar()->maximum(), 0) << widthPx;
        const QRect last = list.visualItemRect(list.item(3));
        EXPECT_TRUE(list.viewport()->rect().contains(last)) << widthPx;
    }
    EXPECT_EQ(list.item(3)->text(), line.label);
    strip.resize(350, strip.height());
    QTest::qWait(50);
    EXPECT_EQ(list.item(3)->text(), QStringLiteral("4"));
    EXPECT_TRUE(list.item(3)->toolTip().contains(line.label));
}

}   // namespace
}   // namespace angiopose::ui
