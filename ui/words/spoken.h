#pragma once

#include <QObject>
#include <QString>
#include <QStringList>
#include <functional>
#include <utility>

class QComboBox;
class QObject;

namespace angiopose::ui {

/// Signal that makes all registered objects update their texts.
class SpokenSignal : public QObject {
    Q_OBJECT
public:
    static SpokenSignal& only()
    {
        static SpokenSignal signal;
        return signal;
    }

signals:
    void again();
};

using Words = std::function<QString()>;

/// Calls `updateText` at once, and on every change of language or shortcuts while `owner` exists. Each later call is
/// a separate event, to keep the window responsive.
void speak(QObject* speaker, std::function<void()> say);

/// Updates all texts after the language or shortcuts have changed.
void speakAgain();

/// Gives a widget a text that follows the language, and returns the widget; the functions below do the same for tooltip
/// and accessible name.
template <class Widget>
Widget* withText(Widget* widget, Words text)
{
    speak(widget, [widget, text = std::move(text)] { widget->setText(text()); });
    return widget;
}

template <class Widget>
Widget* withTip(Widget* widget, Words tip)
{
    speak(widget, [widget, tip = std::move(tip)] { widget->setToolTip(tip()); });
    return widget;
}

template <class Widget>
Widget* withName(Widget* widget, Words name)
{
    speak(widget, [widget, name = std::move(name)] { widget->setAccessibleName(name()); });
    return widget;
}

/// Replaces the item texts of a combo box, keeping its selection.
void setWords(QComboBox& box, const QStringList& choices);

}   // namespace angiopose::ui
