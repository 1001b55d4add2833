#pragma once

#include "ui/archive/archive_rows.h"

#include <QDialog>

class QCheckBox;
class QFormLayout;
class QLineEdit;

namespace angiopose::ui {

class PathField;
class TransferLine;

/// Dialog for the allowed senders and the TLS settings of the storage SCP. Stays open until the input is accepted;
/// deletes itself when closed.
class PortDialog : public QDialog {
    Q_OBJECT
public:
    PortDialog(const ScpSettings& entry, QWidget* parent);

    ScpSettings entry() const;
    TransferLine& line() { return *transferStatus_; }

signals:
    void saveRequested(const ui::ScpSettings& entry);   ///< the receiver calls `accept` or shows the problem

private:
    QFormLayout* makeForm();
    QLayout* makeButtons();
    void fill(const ScpSettings& entry);
    void showState();

    QLineEdit* titles_;
    QLineEdit* hosts_;
    QCheckBox* isTls_;
    PathField* certificate_;
    PathField* key_;
    PathField* ca_;
    TransferLine* transferStatus_;
};

}   // namespace angiopose::ui
