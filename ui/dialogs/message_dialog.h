#pragma once

#include "ui/panels/message_log.h"

#include <QDialog>

namespace angiopose::ui {

/// Error or notice: a heading, one sentence that states problem and remedy, and details that can be copied.
struct Message {
    QString heading;
    QString text;
    QString details;
};

/// Shows a message above its parent, with expandable details that can be copied. Deletes itself when closed.
class MessageDialog : public QDialog {
    Q_OBJECT
public:
    MessageDialog(const Message& message, QWidget* parent);

    static void show(const Message& message, QWidget* parent);
};

/// Question with labeled answer buttons; Enter selects the first answer. `answered` carries the index of the selected
/// answer; by default, closing the dialog selects the last one.
class QuestionDialog : public QDialog {
    Q_OBJECT
public:
    QuestionDialog(const Message& message, const QStringList& answers, QWidget* parent);

    void setAnswerOnClose(int index) { answerOnClose_ = index; }

signals:
    void answered(int index);

private:
    int answerOnClose_;
};

/// Dialog that shows the message log, newest message last; text can be copied. Deletes itself when closed.
class MessageHistory : public QDialog {
    Q_OBJECT
public:
    MessageHistory(const MessageLog& messages, QWidget* parent);
};

}   // namespace angiopose::ui
