#include "tests/app/session/tool_preference.h"
#include "ui/controls/number_field.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QApplication>
#include <QComboBox>
#include <QTest>
#include <QTimer>
#include <QToolButton>

#include <array>

namespace angiopose::test {
namespace {

QString typeNumber(Desk& desk)
{
    const auto fields = usable<ui::NumberField>(desk.window);
    if (fields.empty()) {
        return {};
    }
    ui::NumberField* field = desk.hand.oneOf(fields);
    const bool isPose = desk.window.pose().isAncestorOf(field);
    const double value =
        isPose ? desk.hand.between(-15.0, 15.0) : field->value().value_or(1.0) * desk.hand.between(0.9, 1.1);
    field->setFocus();
    field->selectAll();
    QTest::keyClicks(field, QString::number(value, 'f', 2));
    QTest::keyClick(field, desk.hand.oneIn(6) ? Qt::Key_Escape : Qt::Key_Return);
    return QStringLiteral("type %1 into %2").arg(value).arg(field->accessibleName());
}

QString changeChoice(Desk& desk)
{
    const auto boxes = usable<QComboBox>(desk.window);
    if (boxes.empty()) {
        return {};
    }
    QComboBox* box = desk.hand.oneOf(boxes);
    box->setFocus();
    QTest::keyClick(box, desk.hand.oneIn(2) ? Qt::Key_Down : Qt::Key_Up);
    return QStringLiteral("choose in ") + box->accessibleName();
}

/// Buttons that open something outside the window or discard the case.
bool buttonLeadsAway(const QAbstractButton& button)
{
    return button.text().contains(QStringLiteral("Open")) || button.text().contains(QStringLiteral("Quit"));
}

void workInMenus(RandomHand& hand)
{
    static constexpr int maxMenus = 4;   // one menu may open another
    for (int i = 0; i < maxMenus && QApplication::activePopupWidget(); ++i) {
        workIn(*QApplication::activePopupWidget(), hand);
    }
    while (QWidget* menu = QApplication::activePopupWidget()) {
        menu->close();
    }
}

/// A click on a button with a menu (the overflow button of the menu bar) returns only when the menu closes.
bool holdsMenu(const QAbstractButton& button)
{
    const auto* tool = qobject_cast<const QToolButton*>(&button);
    return tool && tool->menu();
}

QString clickButton(Desk& desk)
{
    const auto buttons = usable<QAbstractButton>(desk.window);
    if (buttons.empty()) {
        return {};
    }
    QAbstractButton* button = desk.hand.oneOf(buttons);
    if (buttonLeadsAway(*button)) {
        return {};
    }
    if (holdsMenu(*button)) {
        QTimer::singleShot(0, button, [&hand = desk.hand] { workInMenus(hand); });
    }
    const QString name = QStringLiteral("button ") + button->text() + button->accessibleName();
    QTest::mouseClick(button, Qt::LeftButton, {}, button->rect().center());
    return name;
}

QString workInList(Desk& desk)
{
    static constexpr std::array keys{Qt::Key_Down, Qt::Key_Up, Qt::Key_Home, Qt::Key_F2, Qt::Key_Space, Qt::Key_Delete};
    const auto views = usable<QAbstractItemView>(desk.window);
    if (views.empty()) {
        return {};
    }
    QAbstractItemView* view = desk.hand.oneOf(views);
    const int choice = desk.hand.below(4);
    if (choice == 0) {
        view->setFocus();
        QTest::keyClick(view, desk.hand.oneOf(keys));
    } else if (choice == 1) {
        desk.hand.askForMenu(*view->viewport());
    } else {
        desk.hand.click(*view->viewport());
    }
    return QStringLiteral("list ") + view->accessibleName();
}

QString resizeWindow(Desk& desk)
{
    desk.window.resize(1000 + desk.hand.below(500), 650 + desk.hand.below(350));
    QApplication::processEvents();
    return QStringLiteral("resize");
}

QString scrollSomewhere(Desk& desk)
{
    const auto widgets = usable<QWidget>(desk.window);
    desk.hand.wheel(*desk.hand.oneOf(widgets));
    return QStringLiteral("wheel somewhere");
}

}   // namespace

std::vector<ToolPreference> panelPreferences()
{
    return {{5, typeNumber}, {3, changeChoice}, {6, clickButton},
            {4, workInList}, {1, resizeWindow}, {1, scrollSomewhere}};
}

}   // namespace angiopose::test
