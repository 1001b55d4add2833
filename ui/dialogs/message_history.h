#pragma once

#include "ui/panels/told_messages.h"

#include <QDialog>

namespace angiopose::ui {

/// All that the window has told, the newest last, to be read again and copied. Deletes itself when closed.
class MessageHistory : public QDialog {
    Q_OBJECT
public:
    MessageHistory(const ToldMessages& messages, QWidget* parent);
};

}   // namespace angiopose::ui
