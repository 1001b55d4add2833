#pragma once

#include <QDialog>

class QPushButton;

namespace angiopose::ui {

class NodeBar;
class TransferLine;

/// Asks to which archive the DICOM objects of a case are sent, and shows how that goes; deletes itself when closed.
class SendDialog : public QDialog {
    Q_OBJECT
public:
    explicit SendDialog(QWidget* parent);

    NodeBar& nodes() { return *nodes_; }
    TransferLine& line() { return *line_; }

    void showState();   ///< what can be done now
    void showNode();   ///< which is chosen now, or that there is none
    void showSent(const QString& words);   ///< nothing is left to do

signals:
    void sendRequested();

private:
    NodeBar* nodes_;
    TransferLine* line_;
    QPushButton* close_;
    QPushButton* send_;
};

}   // namespace angiopose::ui
