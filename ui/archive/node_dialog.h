#pragma once

#include "ui/archive/archive_rows.h"

#include <QDialog>

class QCheckBox;
class QFormLayout;
class QLineEdit;
class QPushButton;

namespace angiopose::ui {

class NumberField;
class PathField;
class TransferLine;

/// Asks how an archive is reached. Stays open until what was entered is found to be good; deletes itself when closed.
class NodeDialog : public QDialog {
    Q_OBJECT
public:
    enum class Purpose { Add, Edit };
    NodeDialog(const ArchiveEntry& entry, Purpose purpose, QWidget* parent);

    ArchiveEntry entry() const;
    TransferLine& line() { return *line_; }

signals:
    void saveRequested(const ui::ArchiveEntry& entry);   ///< answer with `accept` or a problem in the line
    void testRequested(const ui::ArchiveEntry& entry);

private:
    void addRow(QFormLayout& form, const QString& name, QWidget* field, const QString& tip);
    QFormLayout* makeAddress();
    QWidget* makeFurther();
    QLayout* makeButtons(Purpose purpose);
    void fill(const ArchiveEntry& entry);

    QLineEdit* name_;
    QLineEdit* host_;
    NumberField* port_;
    QLineEdit* title_;
    QLineEdit* ownTitle_;
    QLineEdit* webUrl_;
    PathField* authorization_;
    QCheckBox* isTls_;
    PathField* ca_;
    PathField* certificate_;
    PathField* key_;
    QCheckBox* checksHost_;
    NumberField* receivePort_;
    NumberField* answerSeconds_;
    QPushButton* more_;
    QWidget* further_;
    TransferLine* line_;
    QPushButton* test_;
};

}   // namespace angiopose::ui
