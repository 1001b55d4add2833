#pragma once

#include "ui/archive/archive_rows.h"

#include <QDialog>
#include <QWidget>

class QCheckBox;
class QFormLayout;
class QLineEdit;
class QPushButton;

namespace angiopose::ui {

/// Field for a file path, typed or chosen in a file dialog.
class PathField : public QWidget {
    Q_OBJECT
public:
    /// `name` is the accessible name.
    explicit PathField(const QString& name, QWidget* parent = nullptr);

    void setPath(const QString& path);
    QString path() const;
    QLineEdit& line() { return *line_; }

private:
    void choose();

    QString name_;
    QLineEdit* line_;
};

class NumberField;
class PathField;
class TransferLine;

/// Dialog for the connection settings of a PACS. Stays open until the input is accepted; deletes itself when closed.
class NodeDialog : public QDialog {
    Q_OBJECT
public:
    enum class Purpose { Add, Edit };
    NodeDialog(const ArchiveEntry& entry, Purpose purpose, QWidget* parent);

    ArchiveEntry entry() const;
    TransferLine& line() { return *line_; }

signals:
    void saveRequested(const ui::ArchiveEntry& entry);   ///< the receiver calls `accept` or shows the problem
    void testRequested(const ui::ArchiveEntry& entry);

private:
    void addRow(QFormLayout& form, const QString& name, QWidget* field, const QString& tip);
    QFormLayout* makeAddress();
    QWidget* makeAdvancedFields();
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
    QWidget* advanced_;
    TransferLine* line_;
    QPushButton* test_;
};

}   // namespace angiopose::ui
