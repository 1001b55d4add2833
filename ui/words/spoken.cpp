#include "ui/words/spoken.h"

#include "ui/words/spoken_signal.h"

#include <QComboBox>

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
}

}   // namespace angiopose::ui