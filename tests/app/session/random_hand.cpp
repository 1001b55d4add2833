#include "tests/app/session/random_hand.h"

#include <QApplication>
#include <QContextMenuEvent>
#include <QPointer>
#include <QTest>
#include <QWheelEvent>

#include <algorithm>

namespace angiopose::test {

int RandomHand::below(int count)
{
    return static_cast<int>(random_() % static_cast<std::uint64_t>(std::max(1, count)));
}

double RandomHand::between(double low, double high)
{
    return low + (high - low) * (static_cast<double>(random_() >> 11U) * 0x1.0p-53);
}

QPoint RandomHand::somewhereIn(const QWidget& widget)
{
    return {below(widget.width()), below(widget.height())};
}

void RandomHand::press(QWidget& widget, const QKeySequence& keys)
{
    QTest::keySequence(&widget, keys);
}

void RandomHand::click(QWidget& widget, Qt::MouseButton button, Qt::KeyboardModifiers modifiers)
{
    const QPoint at = somewhereIn(widget);
    QTest::mouseMove(&widget, at);
    if (oneIn(6)) {
        QTest::mouseDClick(&widget, button, modifiers, at);
    } else {
        QTest::mouseClick(&widget, button, modifiers, at);
    }
}

void RandomHand::drag(QWidget& widget, Qt::MouseButton button, Qt::KeyboardModifiers modifiers)
{
    const QPointer<QWidget> still(&widget);
    QPoint at = somewhereIn(widget);
    QTest::mousePress(&widget, button, modifiers, at);
    const int steps = 2 + below(6);
    for (int i = 0; i < steps && still; ++i) {
        at += QPoint(below(41) - 20, below(41) - 20);
        QTest::mouseMove(&widget, at);
        QApplication::processEvents();
    }
    if (still && oneIn(8)) {
        QTest::keyClick(&widget, Qt::Key_Escape);
    }
    if (still) {
        QTest::mouseRelease(&widget, button, modifiers, at);
    }
}

void RandomHand::wheel(QWidget& widget)
{
    const QPointF at = somewhereIn(widget);
    QWheelEvent event(at, widget.mapToGlobal(at), {}, {0, oneIn(2) ? 120 : -120}, Qt::NoButton,
                      oneIn(2) ? Qt::ControlModifier : Qt::NoModifier, Qt::NoScrollPhase, false);
    QApplication::sendEvent(&widget, &event);
}

void RandomHand::askForMenu(QWidget& widget)
{
    const QPoint at = somewhereIn(widget);
    QContextMenuEvent event(QContextMenuEvent::Mouse, at, widget.mapToGlobal(at));
    QApplication::sendEvent(&widget, &event);
}

}   // namespace angiopose::test
