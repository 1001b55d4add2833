#include "ui/controls/number_field.h"

#include <QtTest/qtestspontaneevent.h>
#include <gtest/gtest.h>
#include <QApplication>
#include <QComboBox>
#include <QScrollArea>
#include <QScrollBar>
#include <QSpinBox>
#include <QTest>
#include <QVBoxLayout>
#include <QWheelEvent>

using namespace angiopose;

namespace {

/// A choice and a number at the top of a scrollable column.
class WheelGuardTest : public ::testing::Test {
protected:
    WheelGuardTest()
    {
        auto* content = new QWidget;
        auto* layout = new QVBoxLayout(content);
        choice->addItems({QStringLiteral("one"), QStringLiteral("two"), QStringLiteral("three")});
        number->setValue(5);
        layout->addWidget(choice);
        layout->addWidget(number);
        layout->addSpacing(2000);
        column.setWidget(content);
        column.resize(300, 200);
        column.show();
        column.activateWindow();
        EXPECT_TRUE(QTest::qWaitForWindowActive(&column));
        EXPECT_GT(column.verticalScrollBar()->maximum(), 0);
        column.setFocus();
    }
    static void wheelOver(QWidget& widget)
    {
        const QPointF at = widget.rect().center();
        QWheelEvent event(at, widget.mapToGlobal(at), {}, {0, -120}, Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase,
                          false);
        QSpontaneKeyEvent::setSpontaneous(
            &event);   // as if sent by the window system, because only then parents receive it too
        qApp->notify(&widget, &event);
    }

    ui::WheelGuard guard;
    QComboBox* choice = new QComboBox;
    QSpinBox* number = new QSpinBox;
    QScrollArea column;
};

TEST_F(WheelGuardTest, ScrollsWhatLiesAroundABoxWithoutFocus)
{
    wheelOver(*choice);
    EXPECT_EQ(choice->currentIndex(), 0);
    EXPECT_FALSE(choice->hasFocus());
    const int once = column.verticalScrollBar()->value();
    EXPECT_GT(once, 0);
    wheelOver(*number);
    EXPECT_EQ(number->value(), 5);
    EXPECT_GT(column.verticalScrollBar()->value(), once);
}

TEST_F(WheelGuardTest, TurnsTheBoxThatHasTheKeys)
{
    choice->setFocus();
    wheelOver(*choice);
    EXPECT_EQ(choice->currentIndex(), 1);
    number->setFocus();
    wheelOver(*number);
    EXPECT_EQ(number->value(), 4);
}

}   // namespace
