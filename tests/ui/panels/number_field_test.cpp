#include "ui/controls/number_field.h"

#include <gtest/gtest.h>
#include <QApplication>
#include <QSignalSpy>
#include <QTest>
#include <QWheelEvent>

namespace angiopose::ui {
namespace {

NumberFormat millimeters()
{
    return {-100.0, 100.0, 2, QStringLiteral("mm"), 1.0, NumberSign::Always};
}

void typeInto(NumberField& field, const QString& text)
{
    field.selectAll();
    QTest::keyClicks(&field, text);
    QTest::keyClick(&field, Qt::Key_Return);
}

TEST(NumberField, AcceptsPointAndComma)
{
    NumberField field(millimeters());
    QSignalSpy edited(&field, &NumberField::edited);
    typeInto(field, QStringLiteral("1.5"));
    typeInto(field, QStringLiteral("-2,25"));
    ASSERT_EQ(edited.count(), 2);
    EXPECT_DOUBLE_EQ(edited.at(0).first().toDouble(), 1.5);
    EXPECT_DOUBLE_EQ(edited.at(1).first().toDouble(), -2.25);
    EXPECT_EQ(field.text(), QStringLiteral("−2.25"));
}

TEST(NumberField, KeepsItsValueOnNonsenseAndOnEscape)
{
    NumberField field(millimeters());
    field.showValue(3.0);
    QSignalSpy edited(&field, &NumberField::edited);
    typeInto(field, QStringLiteral("abc"));
    field.selectAll();
    QTest::keyClicks(&field, QStringLiteral("7"));
    QTest::keyClick(&field, Qt::Key_Escape);
    EXPECT_EQ(edited.count(), 0);
    EXPECT_EQ(field.text(), QStringLiteral("+3.00"));
}

TEST(NumberField, StaysInItsRange)
{
    NumberField field(millimeters());
    typeInto(field, QStringLiteral("5000"));
    EXPECT_DOUBLE_EQ(field.value().value_or(0.0), 100.0);
}

TEST(NumberField, StepsFineAndCoarse)
{
    NumberField field(millimeters());
    field.showValue(0.0);
    QTest::keyClick(&field, Qt::Key_Up);
    QTest::keyClick(&field, Qt::Key_Up, Qt::ShiftModifier);
    QTest::keyClick(&field, Qt::Key_Down, Qt::ControlModifier);
    EXPECT_NEAR(field.value().value_or(0.0), 10.9, 1e-12);
}

TEST(NumberField, IgnoresTheWheelWithoutFocus)
{
    NumberField field(millimeters());
    field.showValue(1.0);
    QWheelEvent wheel(QPointF(5, 5), QPointF(5, 5), {}, QPoint(0, 120), Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase,
                      false);
    QApplication::sendEvent(&field, &wheel);
    EXPECT_DOUBLE_EQ(field.value().value_or(0.0), 1.0);
}

}   // namespace
}   // namespace angiopose::ui
