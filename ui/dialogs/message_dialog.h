#pragma once

#include "ui/panels/message_log.h"

#include <QDialog>

namespace angiopose::ui {

/// Error or notice: a heading, one sentence with problem and remedy, and details to copy.
struct Message {
    QString heading;
    QString text;
    QString details;
};

/// Shows one message above its parent; details expand and can be copied. Deletes itself when closed.
class MessageDialog : public QDialog {
    Q_OBJECT
public:
    MessageDialog(const Message& message, QWidget* parent);

    static void show(const Message& message, QWidget* parent);
};

/// Question whose answers are verbs; Enter selects the first. `answered` carries the index of the selected answer;
/// closing selects the last one by default.
class QuestionDialog : public QDialog {
    Q_OBJECT
public:
    QuestionDialog(const Message& message, const QStringList& verbs, QWidget* parent);

    void setMeantByClosing(int index) { meantByClosing_ = index; }

signals:
    void answered(int index);

private:
    int meantByClosing_;
};

/// Message log, newest last, for reading and copying. Deletes itself when closed.
class MessageHistory : public QDialog {
    Q_OBJECT
public:
    MessageHistory(const MessageLog& messages, QWidget* parent);
};

}   // namespace angiopose::ui
