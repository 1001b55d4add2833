#pragma once

#include "ui/dialogs/export_dialog.h"

class QPushButton;

namespace angiopose::ui {

class ElidedLabel;

/// Options of a report.
struct ReportOptions {
    Toggle identity = Toggle::Off;
    QString templatePath;   ///< empty for the built-in template
};

/// Dialog for the options of a report: patient identity and template. Emits `chosen` on Export.
class ReportDialog : public QDialog {
    Q_OBJECT
public:
    explicit ReportDialog(const ReportOptions& options, QWidget* parent);

    void showTemplate(const QString& path);   ///< empty for the built-in template
    ReportOptions options() const;

signals:
    void chosen(const ui::ReportOptions& options);
    void templateRequested();   ///< requests a file dialog for a template
    void templateCopyRequested();   ///< requests an editable copy of the built-in template

private:
    QHBoxLayout* makeTemplateButtons();

    QString templatePath_;
    ElidedLabel* template_;
    QPushButton* builtIn_;
    QCheckBox* identity_;
};

}   // namespace angiopose::ui
