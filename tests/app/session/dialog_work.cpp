#include "tests/app/session/tool_preference.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QLineEdit>
#include <QMenu>
#include <QPointer>
#include <QTest>

namespace angiopose::test {
namespace {

constexpr int maxActs = 4;

bool answerLeadsAway(const QAbstractButton& button)
{
    return button.text().contains(QStringLiteral("Open")) || button.text().contains(QStringLiteral("without saving")) ||
           button.text().contains(QStringLiteral("Discard"));
}

void typeInto(QWidget& field, RandomHand& hand)
{
    field.setFocus();
    QTest::keyClick(&field, hand.oneIn(2) ? Qt::Key_Up : Qt::Key_Down);
    QTest::keyClick(&field, Qt::Key_2);
}

void workInRows(QAbstractItemView& view, RandomHand& hand)
{
    if (hand.oneIn(3)) {
        view.setFocus();
        QTest::keyClick(&view, hand.oneIn(2) ? Qt::Key_Down : Qt::Key_Space);
    } else {
        hand.click(*view.viewport());
    }
}

void chooseFrom(QMenu& menu, RandomHand& hand)
{
    const int steps = hand.below(static_cast<int>(menu.actions().size()) + 1);
    for (int i = 0; i < steps; ++i) {
        QTest::keyClick(&menu, Qt::Key_Down);
    }
    QTest::keyClick(&menu, hand.oneIn(3) ? Qt::Key_Escape : Qt::Key_Return);
}

void useOneOf(const QWidget& dialog, RandomHand& hand)
{
    const auto widgets = usable<QWidget>(dialog);
    if (widgets.empty()) {
        return;
    }
    QWidget* widget = hand.oneOf(widgets);
    if (auto* button = qobject_cast<QAbstractButton*>(widget)) {
        if (!answerLeadsAway(*button)) {
            QTest::mouseClick(button, Qt::LeftButton, {}, button->rect().center());
        }
    } else if (auto* view = qobject_cast<QAbstractItemView*>(widget)) {
        workInRows(*view, hand);
    } else if (qobject_cast<QLineEdit*>(widget) || qobject_cast<QComboBox*>(widget) ||
               qobject_cast<QAbstractSpinBox*>(widget)) {
        typeInto(*widget, hand);
    } else {
        hand.click(*widget);
    }
}

}   // namespace

void workIn(QWidget& dialog, RandomHand& hand)
{
    if (auto* menu = qobject_cast<QMenu*>(&dialog)) {
        chooseFrom(*menu, hand);
        return;
    }
    const QPointer<QWidget> still(&dialog);
    const int acts = hand.below(maxActs + 1);
    for (int i = 0; i < acts && still && still->isVisible(); ++i) {
        useOneOf(*still, hand);
        QApplication::processEvents();
    }
}

}   // namespace angiopose::test
