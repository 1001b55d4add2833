#pragma once

#include "io/archive/dimse/receiver.h"
#include "ui/archive/archive_rows.h"

#include <QObject>
#include <QPointer>

namespace angiopose::ui {
class PortDialog;
}   // namespace angiopose::ui

namespace angiopose::app {

/// Who may push to our port and how, as it was entered last.
io::ReceiverOptions receiverOptions(int port, const QString& title);

/// Asks for that, and remembers it.
class PortSecurity : public QObject {
    Q_OBJECT
public:
    explicit PortSecurity(QWidget& dialogParent, QObject* parent = nullptr);

    void ask();

private:
    void save(const ui::PortEntry& entry);

    QWidget& dialogParent_;
    QPointer<ui::PortDialog> dialog_;
};

}   // namespace angiopose::app
