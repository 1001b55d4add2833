#include "ui/dialogs/message_history.h"

#include "ui/words/language.h"

#include <QDialogButtonBox>
#include <QTextBlockFormat>
#include <QTextCursor>
#include <QTextEdit>
#include <QVBoxLayout>

namespace angiopose::ui {
namespace {

/// Longer messages go on below their words, not below their time.
void indentBehindTime(QTextEdit& text)
{
    text.ensurePolished();
    const int width = text.fontMetrics().horizontalAdvance(QStringLiteral("00:00:00   "));
    text.setTabStopDistance(width);
    QTextBlockFormat hanging;
    hanging.setLeftMargin(width);
    hanging.setTextIndent(-width);
    QTextCursor all(text.document());
    all.select(QTextCursor::Document);
    all.mergeBlockFormat(hanging);
}

}   // namespace

MessageHistory::MessageHistory(const ToldMessages& messages, QWidget* parent) : QDialog(parent)
{
    setObjectName(QStringLiteral("messageHistory"));
    setWindowTitle(tr("Messages"));
    setAttribute(Qt::WA_DeleteOnClose);
    resize(640, 420);
    QStringList lines;
    for (const ToldMessage& told : messages.all()) {
        lines << languageLocale().toString(told.time.time(), QStringLiteral("HH:mm:ss")) + QLatin1Char('\t') +
                     told.text;
    }
    auto* text = new QTextEdit;
    text->setReadOnly(true);
    text->setPlaceholderText(tr("Nothing has been told yet."));
    text->setPlainText(lines.join(QLatin1Char('\n')));
    indentBehindTime(*text);
    text->moveCursor(QTextCursor::End);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(text, 1);
    layout->addWidget(buttons);
}

}   // namespace angiopose::ui
