#include "ui/words/retranslation.h"

#include <QApplication>
#include <QComboBox>
#include <QEvent>

namespace angiopose::ui {

void keepTranslated(QObject* owner, std::function<void()> updateText)
{
    updateText();
    QObject::connect(&RetranslateSignal::instance(), &RetranslateSignal::retranslationRequested, owner,
                     std::move(updateText), Qt::QueuedConnection);
}

void retranslate()
{
    emit RetranslateSignal::instance().retranslationRequested();
}

void setItemTexts(QComboBox& box, const QStringList& choices)
{
    while (box.count() < choices.size()) {
        box.addItem({});
    }
    for (int i = 0; i < choices.size(); ++i) {
        box.setItemText(i, choices[i]);
    }
    QEvent styleChange(QEvent::StyleChange);   // makes Qt discard the cached minimum width of the previous text
    QApplication::sendEvent(&box, &styleChange);
}

}   // namespace angiopose::ui
