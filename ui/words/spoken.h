#pragma once

#include <QObject>
#include <QString>
#include <QStringList>
#include <functional>
#include <utility>

class QComboBox;
class QObject;

namespace angiopose::ui {

/// Notifies all registered objects to update their texts.
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

/// Calls `say` now, and again whenever the language or the shortcuts change, for the lifetime of `speaker`. Each
/// repeated call is a separate event, which keeps the window responsive.
void speak(QObject* speaker, std::function<void()> say);

/// Updates all texts after a change of language or shortcuts.
void speakAgain();

/// Returns the widget with a text that follows the language; the functions below do the same for its tooltip and
/// accessible name.
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

/// Replaces the item texts of a combo box and keeps its selection.
void setWords(QComboBox& box, const QStringList& choices);

}   // namespace angiopose::ui
