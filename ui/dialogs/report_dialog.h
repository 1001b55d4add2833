#pragma once

#include "ui/dialogs/export_dialog.h"

class QPushButton;

namespace angiopose::ui {

class ElidedLabel;

/// Options of a report.
struct ReportChoice {
    Choice identity = Choice::Off;
    QString templatePath;   ///< empty: built-in template
};

/// Asks whether the report names the patient and which template to use. Emits `chosen` on Export.
class ReportDialog : public QDialog {
    Q_OBJECT
public:
    explicit ReportDialog(const ReportChoice& choice, QWidget* parent);

    void showTemplate(const QString& path);   ///< empty: built-in template
    ReportChoice choice() const;

signals:
    void chosen(const ui::ReportChoice& choice);
    void templateWanted();   ///< the user wants to choose a template file
    void copyWanted();   ///< the user wants an editable copy of the built-in template

private:
    QHBoxLayout* makeTemplateButtons();

    QString templatePath_;
    ElidedLabel* template_;
    QPushButton* builtIn_;
    QCheckBox* identity_;
};

}   // namespace angiopose::ui
