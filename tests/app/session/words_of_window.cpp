#include "tests/app/session/words_of_window.h"

#include "ui/panels/bottom_strip.h"
#include "ui/panels/welcome_page.h"

#include <QAbstractButton>
#include <QAction>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>

namespace angiopose::test {
namespace {

/// True for notes and times, which belong to the session, and recent cases, which belong to the settings.
bool isOfTheSession(const QWidget& widget)
{
    const QWidget* parent = widget.parentWidget();
    return (qobject_cast<const ui::BottomStrip*>(parent) && qobject_cast<const QLabel*>(&widget)) ||
           (qobject_cast<const ui::WelcomePage*>(parent) &&
            (widget.property("role") == QLatin1String("link") || widget.property("role") == QLatin1String("recent")));
}

QStringList textsOf(const QWidget& widget)
{
    if (const auto* label = qobject_cast<const QLabel*>(&widget)) {
        return {label->text()};
    }
    if (const auto* button = qobject_cast<const QAbstractButton*>(&widget)) {
        return {button->text()};
    }
    if (const auto* field = qobject_cast<const QLineEdit*>(&widget)) {
        return {field->text(), field->placeholderText()};
    }
    if (const auto* menu = qobject_cast<const QMenu*>(&widget)) {
        return {menu->title()};
    }
    QStringList texts;
    if (const auto* box = qobject_cast<const QComboBox*>(&widget)) {
        for (int i = 0; i < box->count(); ++i) {
            texts << box->itemText(i) << box->itemData(i, Qt::ToolTipRole).toString();
        }
    } else if (const auto* list = qobject_cast<const QListWidget*>(&widget)) {
        for (int i = 0; i < list->count(); ++i) {
            texts << list->item(i)->text();
        }
    }
    return texts;
}

}   // namespace

QStringList wordsOf(const QWidget& window)
{
    QStringList words{window.windowTitle()};
    for (const QWidget* widget : window.findChildren<QWidget*>()) {
        if (!isOfTheSession(*widget)) {
            QStringList parts{QString::fromLatin1(widget->metaObject()->className()), widget->objectName()};
            parts << textsOf(*widget) << widget->toolTip() << widget->accessibleName();
            words << parts.join(QLatin1Char('|'));
        }
    }
    for (const QAction* action : window.findChildren<QAction*>()) {
        words << QStringLiteral("action|%1|%2").arg(action->objectName(), action->text());
    }
    return words;
}

}   // namespace angiopose::test
