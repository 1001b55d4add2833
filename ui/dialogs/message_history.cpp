#include "ui/dialogs/message_history.h"

#include "ui/words/language.h"

#include <QDialogButtonBox>
#include <QPlainTextEdit>
#include <QVBoxLayout>

namespace angiopose::ui {

MessageHistory::MessageHistory(const ToldMessages& messages, QWidget* parent) : QDialog(parent)
{
    setObjectName(QStringLiteral("messageHistory"));
    setWindowTitle(tr("Messages"));
    setAttribute(Qt::WA_DeleteOnClose);
    resize(640, 420);
    QStringList lines;
    for (const ToldMessage& told : messages.all()) {
        lines << languageLocale().toString(told.time.time(), QStringLiteral("HH:mm:ss")) + QStringLiteral("   ") +
                     told.text;
    }
    auto* text = new QPlainTextEdit(lines.join(QLatin1Char('\n')));
    text->setReadOnly(true);
    text->setPlaceholderText(tr("Nothing has been told yet."));
    text->moveCursor(QTextCursor::End);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(text, 1);
    layout->addWidget(buttons);
}

}   // namespace angiopose::ui
