#pragma once

#include "app/document/case_document.h"
#include "app/registration/target_provider.h"
#include "ui/dialogs/report_dialog.h"

#include <QObject>

class QWidget;

namespace angiopose::app {

class ExportController;

/// The report of a case: asked for, by which template, written by the export.
class ReportController : public QObject {
    Q_OBJECT
public:
    ReportController(CaseDocument& document, TargetProvider& target, ExportController& exporting, QWidget& dialogParent,
                     QObject* parent = nullptr);

    void ask();

signals:
    void failed(const QString& reason);

private:
    void askTemplate(ui::ReportDialog& dialog);
    void askCopy();
    void askFile(const ui::ReportChoice& choice);

    CaseDocument& document_;
    TargetProvider& target_;
    ExportController& exporting_;
    QWidget& dialogParent_;
};

}   // namespace angiopose::app
