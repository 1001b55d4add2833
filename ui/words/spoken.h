#pragma once

#include <QObject>
#include <QString>
#include <QStringList>
#include <functional>
#include <utility>

class QComboBox;
class QObject;

namespace angiopose::ui {

/// Tells all speakers of the program that their words are others now.
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

/// Does `say` now, and again whenever the window speaks another language or has other keys, as long as `speaker` lives.
/// The repetitions are events of their own, so that none of them holds the window up.
void speak(QObject* speaker, std::function<void()> say);

/// Language or keys are others now: all that was said is said again.
void speakAgain();

/// The widget with a text that follows the language; likewise its tool tip and its accessible name.
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

/// The choices of a box in other words, its choice kept.
void setWords(QComboBox& box, const QStringList& choices);

}   // namespace angiopose::ui
