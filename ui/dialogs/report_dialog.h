#pragma once

#include "ui/dialogs/export_dialog.h"

class QPushButton;

namespace angiopose::ui {

class ElidedLabel;

/// How the user wants a report.
struct ReportChoice {
    Choice identity = Choice::Off;
    QString templatePath;   ///< empty: the built-in one
};

/// Asks whether a report names the patient and which template it is made by. `chosen` follows on Export.
class ReportDialog : public QDialog {
    Q_OBJECT
public:
    explicit ReportDialog(const ReportChoice& choice, QWidget* parent);

    void showTemplate(const QString& path);   ///< empty: the built-in one
    ReportChoice choice() const;

signals:
    void chosen(const ui::ReportChoice& choice);
    void templateWanted();   ///< another file is to be chosen
    void copyWanted();   ///< of the built-in one, to be changed

private:
    QHBoxLayout* makeTemplateButtons();

    QString templatePath_;
    ElidedLabel* template_;
    QPushButton* builtIn_;
    QCheckBox* identity_;
};

}   // namespace angiopose::ui
