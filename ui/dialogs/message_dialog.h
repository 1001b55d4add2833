#pragma once

#include "ui/panels/message_log.h"

#include <QDialog>

namespace angiopose::ui {

/// What went wrong or what to know: a heading, one sentence on problem and remedy, details to copy.
struct Message {
    QString heading;
    QString text;
    QString details;
};

/// Shows one message over its parent; details fold out and can be copied. Deletes itself when closed.
class MessageDialog : public QDialog {
    Q_OBJECT
public:
    MessageDialog(const Message& message, QWidget* parent);

    static void show(const Message& message, QWidget* parent);
};

/// A question whose answers are verbs, the first under Enter. `answered` carries the index of the chosen verb; closing
/// means the last one unless told otherwise.
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

/// All that the window has told, the newest last, to be read again and copied. Deletes itself when closed.
class MessageHistory : public QDialog {
    Q_OBJECT
public:
    MessageHistory(const MessageLog& messages, QWidget* parent);
};

}   // namespace angiopose::ui
