#pragma once

#include <QObject>
#include <QString>
#include <QStringList>
#include <functional>
#include <utility>

class QComboBox;
class QObject;

namespace angiopose::ui {

/// Signal on which all registered objects update their text.
class RetranslateSignal : public QObject {
    Q_OBJECT
public:
    static RetranslateSignal& instance()
    {
        static RetranslateSignal signal;
        return signal;
    }

signals:
    void retranslationRequested();
};

using LocalizedText = std::function<QString()>;

/// Calls `updateText` at once, and on every change of language or shortcuts while `owner` exists. Every later call is a
/// separate event, which keeps the window responsive.
void keepTranslated(QObject* owner, std::function<void()> updateText);

/// Updates all UI text after the language or shortcuts have changed.
void retranslate();

/// Gives a widget text that follows the UI language, and returns the widget; the functions below do the same for the
/// tooltip and the accessible name.
template <class Widget>
Widget* withText(Widget* widget, LocalizedText text)
{
    keepTranslated(widget, [widget, text = std::move(text)] { widget->setText(text()); });
    return widget;
}

template <class Widget>
Widget* withToolTip(Widget* widget, LocalizedText tip)
{
    keepTranslated(widget, [widget, tip = std::move(tip)] { widget->setToolTip(tip()); });
    return widget;
}

template <class Widget>
Widget* withAccessibleName(Widget* widget, LocalizedText name)
{
    keepTranslated(widget, [widget, name = std::move(name)] { widget->setAccessibleName(name()); });
    return widget;
}

/// Replaces the item text of a combo box and keeps its selection.
void setItemTexts(QComboBox& box, const QStringList& choices);

}   // namespace angiopose::ui
