#include "tests/app/session/habit.h"
#include "ui/views/angiogram_view.h"

#include <QApplication>
#include <QTest>

#include <array>

namespace angiopose::test {
namespace {

/// Keys that no command has: of modes, tools and lists. What is here twice is pressed twice as often.
constexpr std::array modeKeys{
    "Left", "Right", "Up",  "Down", "Shift+Left", "Ctrl+Right", "Alt+Up", "Alt+Left", "PgUp",   "Shift+PgDown", ",",
    ".",    "Home",  "End", "Esc",  "Esc",        "Return",     "Del",    "Ctrl+Z",   "Ctrl+Z", "Ctrl+Y",       "N"};

/// Of the curve editor: what the left button does, and what ends a stroke.
constexpr std::array curveKeys{"X", "E", "D", "C", "B", "L", "[", "]", "Return", "Backspace", "Esc"};

QString pressModeKey(Desk& desk)
{
    const QKeySequence keys(QString::fromLatin1(desk.hand.oneOf(modeKeys)));
    ui::AngiogramView& view = desk.window.angiogramView();
    view.setFocus();
    desk.hand.press(view, keys);
    return QStringLiteral("key ") + keys.toString();
}

QString holdHide(Desk& desk)
{
    ui::AngiogramView& view = desk.window.angiogramView();
    QTest::keyPress(&view, Qt::Key_H);
    QApplication::processEvents();
    QTest::keyRelease(&view, Qt::Key_H);
    return QStringLiteral("hold H");
}

QString dragInImage(Desk& desk)
{
    static constexpr std::array buttons{Qt::LeftButton, Qt::LeftButton, Qt::MiddleButton, Qt::RightButton};
    static constexpr std::array modifiers{Qt::NoModifier, Qt::NoModifier, Qt::ControlModifier, Qt::ShiftModifier};
    const Qt::MouseButton button = desk.hand.oneOf(buttons);
    desk.hand.drag(desk.window.angiogramView(), button, desk.hand.oneOf(modifiers));
    return QStringLiteral("drag in image with button %1").arg(static_cast<int>(button));
}

QString wheelOverImage(Desk& desk)
{
    desk.hand.wheel(desk.window.angiogramView());
    return QStringLiteral("wheel over image");
}

QString clickInImage(Desk& desk)
{
    desk.hand.click(desk.window.angiogramView(), Qt::LeftButton,
                    desk.hand.oneIn(3) ? Qt::ControlModifier : Qt::NoModifier);
    return QStringLiteral("click in image");
}

QString askForMenu(Desk& desk)
{
    desk.hand.askForMenu(desk.window.angiogramView());
    return QStringLiteral("menu of image");
}

/// A few strokes with the curve editor, which stays open.
QString drawCurves(Desk& desk)
{
    ui::AngiogramView& view = desk.window.angiogramView();
    desk.window.actions()[ui::Command::EditVessels]->setChecked(true);
    view.setFocus();
    for (int i = 0; i < 4; ++i) {
        if (desk.hand.oneIn(2)) {
            desk.hand.press(view, QKeySequence(QString::fromLatin1(desk.hand.oneOf(curveKeys))));
        } else if (desk.hand.oneIn(2)) {
            desk.hand.drag(view, Qt::LeftButton);
        } else {
            desk.hand.click(view);
        }
        QApplication::processEvents();
    }
    return QStringLiteral("edit curves");
}

/// Subtracted, and the mask moved: by hand or by keys.
QString shiftMask(Desk& desk)
{
    ui::AngiogramView& view = desk.window.angiogramView();
    desk.window.actions()[ui::Command::ShiftMask]->setChecked(true);
    view.setFocus();
    if (desk.hand.oneIn(2)) {
        desk.hand.drag(view, Qt::LeftButton);
    } else {
        desk.hand.press(view, QKeySequence(Qt::Key_Left));
    }
    return QStringLiteral("move the mask");
}

}   // namespace

std::vector<Habit> imageHabits()
{
    return {{16, pressModeKey}, {3, holdHide},   {14, dragInImage}, {10, wheelOverImage},
            {8, clickInImage},  {2, askForMenu}, {3, drawCurves},   {2, shiftMask}};
}

}   // namespace angiopose::test