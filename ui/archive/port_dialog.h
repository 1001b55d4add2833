#pragma once

#include "ui/archive/archive_rows.h"

#include <QDialog>

class QCheckBox;
class QFormLayout;
class QLineEdit;

namespace angiopose::ui {

class PathField;
class TransferLine;

/// Asks who may push to our port, and whether encrypted. Stays open until what was entered is found to be good; deletes
/// itself when closed.
class PortDialog : public QDialog {
    Q_OBJECT
public:
    PortDialog(const PortEntry& entry, QWidget* parent);

    PortEntry entry() const;
    TransferLine& line() { return *line_; }

signals:
    void saveRequested(const ui::PortEntry& entry);   ///< answer with `accept` or a problem in the line

private:
    QFormLayout* makeForm();
    QLayout* makeButtons();
    void fill(const PortEntry& entry);
    void showState();

    QLineEdit* titles_;
    QLineEdit* hosts_;
    QCheckBox* isTls_;
    PathField* certificate_;
    PathField* key_;
    PathField* ca_;
    TransferLine* line_;
};

}   // namespace angiopose::ui
