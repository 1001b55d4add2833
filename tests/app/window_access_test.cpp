#include "tests/app/open_window.h"

#include "ui/controls/section.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSlider>
#include <QAccessible>
#include <QComboBox>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPointer>
#include <QScrollArea>
#include <QScrollBar>

#include <set>
#include <vector>

namespace angiopose::app {
namespace {

using test::SampleWindow;

bool isControl(const QWidget& widget)
{
    return qobject_cast<const QAbstractButton*>(&widget) || qobject_cast<const QLineEdit*>(&widget) ||
           qobject_cast<const QComboBox*>(&widget) || qobject_cast<const QAbstractItemView*>(&widget) ||
           (qobject_cast<const QAbstractSlider*>(&widget) && !qobject_cast<const QScrollBar*>(&widget)) ||
           qobject_cast<const QPlainTextEdit*>(&widget);
}

/// True for parts that Qt creates inside its own controls.
bool isInner(const QWidget& widget)
{
    for (const QWidget* outer = widget.parentWidget(); outer; outer = outer->parentWidget()) {
        if (qobject_cast<const QComboBox*>(outer) || qobject_cast<const QLineEdit*>(outer)) {
            return true;
        }
    }
    return widget.objectName().startsWith(QLatin1String("qt_"));
}

std::string described(const QWidget& widget)
{
    return std::string(widget.metaObject()->className()) + " in " +
           (widget.parentWidget() ? widget.parentWidget()->metaObject()->className() : "nothing");
}

void unfoldAll(QWidget& window)
{
    for (ui::Section* section : window.findChildren<ui::Section*>()) {
        section->setFolded(false);
    }
    QApplication::processEvents();
}

TEST(WindowAccess, EveryControlHasAName)
{
    SampleWindow w;
    unfoldAll(w.window);
    int controls = 0;
    for (QWidget* widget : w.window.findChildren<QWidget*>()) {
        const bool takesFocus = (widget->focusPolicy() & Qt::TabFocus) != 0 && !qobject_cast<QScrollArea*>(widget);
        if (!(isControl(*widget) || takesFocus) || isInner(*widget) || !widget->isVisible()) {
            continue;
        }
        ++controls;
        QAccessibleInterface* spoken = QAccessible::queryAccessibleInterface(widget);
        ASSERT_TRUE(spoken) << described(*widget);
        EXPECT_FALSE(spoken->text(QAccessible::Name).isEmpty()) << described(*widget);
    }
    EXPECT_GT(controls, 30);
}

TEST(WindowAccess, TabReachesEveryControl)
{
    SampleWindow w;
    unfoldAll(w.window);
    w.window.angiogramView().setFocus();
    std::set<QWidget*> reached;
    for (int i = 0; i < 300; ++i) {
        QWidget* focused = QApplication::focusWidget();
        ASSERT_TRUE(focused) << i;
        if (!reached.insert(focused).second && focused == &w.window.angiogramView()) {
            break;   // the focus has gone full circle
        }
        QTest::keyClick(focused, Qt::Key_Tab);
    }
    for (QWidget* widget : w.window.findChildren<QWidget*>()) {
        if (isControl(*widget) && !isInner(*widget) && widget->isVisible() && widget->isEnabled() &&
            (widget->focusPolicy() & Qt::ClickFocus) != 0) {
            EXPECT_TRUE(reached.contains(widget))
                << described(*widget) << " " << widget->accessibleName().toStdString();
        }
    }
    EXPECT_GT(reached.size(), 25U);
}

/// A control with keyboard focus must look different from one without.
TEST(WindowAccess, FocusIsSeenOnEveryKindOfControl)
{
    SampleWindow w;
    w.waitForJudgement();   // it creates new rows
    std::set<std::string> kinds;
    const QList<QWidget*> all = w.window.findChildren<QWidget*>();
    for (const QPointer<QWidget>& widget : std::vector<QPointer<QWidget>>(all.begin(), all.end())) {
        const bool counts = widget && isControl(*widget) && !isInner(*widget) && widget->isVisible() &&
                            widget->isEnabled() && (widget->focusPolicy() & Qt::TabFocus) != 0 &&
                            !widget->visibleRegion().isEmpty();
        if (!counts || !kinds.insert(widget->metaObject()->className()).second) {
            continue;
        }
        w.window.angiogramView().setFocus();
        QApplication::processEvents();
        if (!widget) {
            continue;
        }
        const QImage without = widget->grab().toImage();
        widget->setFocus(Qt::TabFocusReason);
        QApplication::processEvents();
        ASSERT_TRUE(widget);
        EXPECT_NE(widget->grab().toImage(), without) << described(*widget);
    }
    EXPECT_GT(kinds.size(), 4U);
}

}   // namespace
}   // namespace angiopose::app
