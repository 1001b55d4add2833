#include "tests/app/session/tool_preference.h"
#include "ui/places/side_by_side.h"
#include "ui/views/angiogram_view.h"

#include <QApplication>
#include <QTest>

#include <array>

namespace angiopose::test {
namespace {

/// Keys of modes, tools and lists that are not shortcuts of commands. A key listed twice is pressed twice as often.
constexpr std::array modeKeys{
    "Left", "Right", "Up",  "Down", "Shift+Left", "Ctrl+Right", "Alt+Up", "Alt+Left", "PgUp",   "Shift+PgDown", ",",
    ".",    "Home",  "End", "Esc",  "Esc",        "Return",     "Del",    "Ctrl+Z",   "Ctrl+Z", "Ctrl+Y",       "N"};

/// Keys of the curve editor: functions of the left button, and the end of a stroke.
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

QString useOtherView(Desk& desk)
{
    ui::SideBySide& images = desk.window.sideBySide();
    if (images.paneCount() == 0) {
        return {};
    }
    ui::ViewPane& pane = images.pane(static_cast<std::size_t>(desk.hand.below(static_cast<int>(images.paneCount()))));
    switch (desk.hand.below(5)) {
        case 0:
            desk.hand.drag(pane.image(), Qt::LeftButton);
            return QStringLiteral("drag in another view");
        case 1:
            desk.hand.wheel(pane.image());
            return QStringLiteral("wheel over another view");
        case 2:
            desk.hand.click(pane.title());
            return QStringLiteral("click on the name of another view");
        case 3:
            QTest::mouseDClick(&pane.image(), Qt::LeftButton, {}, desk.hand.somewhereIn(pane.image()));
            return QStringLiteral("double click in another view");
        default:
            desk.hand.click(pane.image());
            return QStringLiteral("click in another view");
    }
}

}   // namespace

std::vector<ToolPreference> imagePreferences()
{
    return {{16, pressModeKey}, {3, holdHide},   {14, dragInImage}, {10, wheelOverImage}, {8, clickInImage},
            {2, askForMenu},    {3, drawCurves}, {2, shiftMask},    {4, useOtherView}};
}

}   // namespace angiopose::test
