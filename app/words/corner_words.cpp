#include "app/words/corner_words.h"

#include "ui/words/language.h"
#include "ui/words/message_text.h"

namespace angiopose::app {

ui::CornerTexts windowTexts(const CornerLines& lines)
{
    ui::CornerTexts texts =
        textsOf(lines, [](const core::Message& message) { return ui::messageText(message).toStdString(); });
    texts.decimalSign = ui::languageLocale().decimalPoint() == QLatin1String(",") ? ',' : '.';
    return texts;
}

}   // namespace angiopose::app
