#include "ui/words/spoken.h"

#include <QApplication>
#include <QComboBox>
#include <QEvent>

namespace angiopose::ui {

void speak(QObject* speaker, std::function<void()> say)
{
    say();
    QObject::connect(&SpokenSignal::only(), &SpokenSignal::again, speaker, std::move(say), Qt::QueuedConnection);
}

void speakAgain()
{
    emit SpokenSignal::only().again();
}

void setWords(QComboBox& box, const QStringList& choices)
{
    while (box.count() < choices.size()) {
        box.addItem({});
    }
    for (int i = 0; i < choices.size(); ++i) {
        box.setItemText(i, choices[i]);
    }
    QEvent measuredAgain(QEvent::StyleChange);   // makes Qt discard the cached minimum width of the previous texts
    QApplication::sendEvent(&box, &measuredAgain);
}

}   // namespace angiopose::ui
