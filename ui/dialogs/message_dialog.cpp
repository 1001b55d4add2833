#include "ui/dialogs/message_dialog.h"

#include "ui/controls/section.h"
#include "ui/words/language.h"

#include <QClipboard>
#include <QDialogButtonBox>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QTextBlockFormat>
#include <QTextCursor>
#include <QTextEdit>
#include <QVBoxLayout>

namespace angiopose::ui {
namespace {

constexpr int messageDialogWidth = 460;

QVBoxLayout* makeBody(QDialog* dialog, const Message& message)
{
    auto* layout = new QVBoxLayout(dialog);
    layout->setContentsMargins(22, 20, 22, 16);
    layout->setSpacing(12);
    auto* heading = roleLabel("heading", message.heading);
    auto* text = roleLabel("body", message.text);
    for (QLabel* label : {heading, text}) {
        label->setWordWrap(true);
        label->setTextFormat(Qt::PlainText);
    }
    text->setTextInteractionFlags(Qt::TextSelectableByMouse);
    layout->addWidget(heading);
    layout->addWidget(text);
    dialog->setWindowTitle(message.heading);
    dialog->setMinimumWidth(messageDialogWidth);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    return layout;
}

/// Indents wrapped lines to align with the message text after the time.
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

MessageDialog::MessageDialog(const Message& message, QWidget* parent) : QDialog(parent)
{
    setObjectName(QStringLiteral("messageDialog"));
    auto* layout = makeBody(this, message);
    auto* details = new QPlainTextEdit(message.details);
    details->setReadOnly(true);
    details->setMaximumHeight(130);
    details->hide();
    layout->addWidget(details);

    auto* buttons = new QHBoxLayout;
    if (!message.details.isEmpty()) {
        auto* unfold = new QPushButton(tr("Details"));
        unfold->setCheckable(true);
        connect(unfold, &QPushButton::toggled, this, [this, details](bool on) {
            details->setVisible(on);
            adjustSize();
        });
        auto* copy = new QPushButton(tr("Copy details"));
        connect(copy, &QPushButton::clicked, this, [message] {
            QGuiApplication::clipboard()->setText(message.text + QLatin1Char('\n') + message.details);
        });
        buttons->addWidget(unfold);
        buttons->addWidget(copy);
    }
    auto* close = new QPushButton(tr("Close"));
    close->setProperty("role", "primary");
    close->setDefault(true);
    connect(close, &QPushButton::clicked, this, &QDialog::accept);
    buttons->addStretch(1);
    buttons->addWidget(close);
    layout->addLayout(buttons);
    close->setFocus();
}

void MessageDialog::show(const Message& message, QWidget* parent)
{
    (new MessageDialog(message, parent))->open();
}

QuestionDialog::QuestionDialog(const Message& message, const QStringList& answers, QWidget* parent)
    : QDialog(parent), answerOnClose_(static_cast<int>(answers.size()) - 1)
{
    setObjectName(QStringLiteral("questionDialog"));
    auto* layout = makeBody(this, message);
    auto* buttons = new QHBoxLayout;
    buttons->addStretch(1);
    for (int i = static_cast<int>(answers.size()) - 1; i >= 0; --i) {
        auto* button = new QPushButton(answers[i]);
        if (i == 0) {
            button->setProperty("role", "primary");
            button->setDefault(true);
        }
        connect(button, &QPushButton::clicked, this, [this, i] { done(i + 1); });
        buttons->addWidget(button);
    }
    layout->addLayout(buttons);
    if (buttons->count() > 1) {
        buttons->itemAt(buttons->count() - 1)->widget()->setFocus();   // makes Enter trigger the highlighted button
    }
    connect(this, &QDialog::finished, this, [this](int code) { emit answered(code == 0 ? answerOnClose_ : code - 1); });
}

MessageHistory::MessageHistory(const MessageLog& messages, QWidget* parent) : QDialog(parent)
{
    setObjectName(QStringLiteral("messageHistory"));
    setWindowTitle(tr("Messages"));
    setAttribute(Qt::WA_DeleteOnClose);
    resize(640, 420);
    QStringList lines;
    for (const LoggedMessage& reported : messages.all()) {
        lines << languageLocale().toString(reported.time.time(), QStringLiteral("HH:mm:ss")) + QLatin1Char('\t') +
                     reported.text;
    }
    auto* text = new QTextEdit;
    text->setReadOnly(true);
    text->setPlaceholderText(tr("No messages yet."));
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
