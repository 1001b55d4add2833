#pragma once

#include "ui/dialogs/export_dialog.h"

class QPushButton;

namespace angiopose::ui {

class ElidedLabel;

/// Options of a report.
struct ReportChoice {
    Choice identity = Choice::Off;
    QString templatePath;   ///< empty for the built-in template
};

/// Dialog for the options of a report: patient identity and template. Emits `chosen` on Export.
class ReportDialog : public QDialog {
    Q_OBJECT
public:
    explicit ReportDialog(const ReportChoice& choice, QWidget* parent);

    void showTemplate(const QString& path);   ///< empty for the built-in template
    ReportChoice choice() const;

signals:
    void chosen(const ui::ReportChoice& choice);
    void templateWanted();   ///< requests a file dialog for a template
    void copyWanted();   ///< requests an editable copy of the built-in template

private:
    QHBoxLayout* makeTemplateButtons();

    QString templatePath_;
    ElidedLabel* template_;
    QPushButton* builtIn_;
    QCheckBox* identity_;
};

}   // namespace angiopose::ui
