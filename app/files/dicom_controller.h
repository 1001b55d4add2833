#pragma once

#include "app/document/case_document.h"
#include "app/jobs/file_queue.h"
#include "app/registration/target_provider.h"
#include "app/texts/dicom_export.h"
#include "ui/dialogs/export_dialog.h"
#include "ui/dialogs/report_dialog.h"

#include <QObject>
#include <QStringList>
#include <functional>

class QWidget;

namespace angiopose::app {

class ExportController;

/// Exports the case as DICOM objects: asks for the options, then writes to a folder on a worker.
class DicomController : public QObject {
    Q_OBJECT
public:
    DicomController(CaseDocument& document, TargetProvider& target, ExportController& exportController,
                    QWidget& dialogParent, QObject* parent = nullptr);

    void openDialog();
    /// Asks which objects to send; emits `wanted` if the user selects any.
    void selectObjectsToSend();

    /// Creates the objects of the current case in a folder. May run on any thread.
    using ObjectWriter =
        std::function<core::Result<DicomFiles>(const std::string& folder, const DicomObserver& observe)>;
    ObjectWriter makeWriter(const ui::DicomExportOptions& choice) const;

    void write(const ui::DicomExportOptions& choice, const QString& folder);   ///< returns at once

signals:
    void started();
    void written(const QString& folder, const QStringList& notes);
    void failed(const QString& reason);
    void wanted(const ui::DicomExportOptions& choice);   ///< emitted with the objects to send

private:
    ui::DicomDialog* createDialog(ui::DicomPurpose purpose);
    std::vector<ui::DicomPart> availableParts() const;
    void askForFolder(const ui::DicomExportOptions& choice);
    DicomExport exportOptions(const ui::DicomExportOptions& choice) const;

    CaseDocument& document_;
    TargetProvider& target_;
    ExportController& exportController_;
    QWidget& dialogParent_;
    FileQueue files_;
};

class ExportController;

/// Asks for the options and the template of a case report and writes the report through the export controller.
class ReportController : public QObject {
    Q_OBJECT
public:
    ReportController(CaseDocument& document, TargetProvider& target, ExportController& exportController,
                     QWidget& dialogParent, QObject* parent = nullptr);

    void openDialog();

signals:
    void failed(const QString& reason);

private:
    void askForTemplate(ui::ReportDialog& dialog);
    void askForCopyPath();
    void askForFile(const ui::ReportOptions& choice);

    CaseDocument& document_;
    TargetProvider& target_;
    ExportController& exportController_;
    QWidget& dialogParent_;
};

}   // namespace angiopose::app
