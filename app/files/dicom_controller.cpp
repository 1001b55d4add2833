#include "app/files/dicom_controller.h"

#include "app/files/export_controller.h"
#include "app/preferences/private_mode.h"
#include "app/preferences/save_folder.h"
#include "app/preferences/settings.h"
#include "app/report/case_report.h"
#include "app/report/report_template.h"
#include "app/words/snapshot_texts.h"
#include "io/dicom/objects/case_measurements.h"
#include "io/support/atomic_file.h"
#include "ui/words/message_text.h"

#include <QApplication>
#include <QFileDialog>
#include <QFileInfo>
#include <memory>

namespace angiopose::app {
namespace {

/// Returns a function that creates the same report as the menu command.
std::function<core::Result<std::string>()> reportMaker(const core::Case& session, const core::Centerline2d& target,
                                                       const OverlayImageOptions& imageOptions)
{
    return [session, target, imageOptions, author = observerName(), typeface = QApplication::font().families(),
            page = settings::reportTemplate.read()]() -> core::Result<std::string> {
        const auto views = evaluateViews(session, target, imageOptions);
        if (!views) {
            return views.error();
        }
        const auto bytes = reportBytes({views.value(), author, typeface, page}, ReportKind::Pdf);
        return bytes ? core::Result<std::string>(bytes.value().toStdString()) : bytes.error();
    };
}

core::Status writeBytes(const QByteArray& bytes, const QString& path)
{
    return io::writeAtomically(path.toStdString(), {bytes.constData(), static_cast<std::size_t>(bytes.size())});
}

}   // namespace

DicomController::DicomController(CaseDocument& document, TargetProvider& target, ExportController& exportController,
                                 QWidget& dialogParent, QObject* parent)
    : QObject(parent),
      document_(document),
      target_(target),
      exportController_(exportController),
      dialogParent_(dialogParent)
{
}

std::vector<ui::DicomPart> DicomController::availableParts() const
{
    using ui::DicomPart;
    const core::Case& current = document_.current();
    std::vector<DicomPart> parts{DicomPart::Picture};
    if (current.shown().angiogram->frameCount() > 1) {
        parts.push_back(DicomPart::Run);
    }
    if (target_.current()) {
        parts.push_back(DicomPart::Report);
    }
    if (!current.shown().angiogram->identity.sopInstanceUid.empty()) {
        parts.push_back(DicomPart::State);
    }
    parts.push_back(DicomPart::Registration);
    if (current.vessels.lumen || current.vessels.scan) {
        parts.push_back(DicomPart::Segmentation);
    }
    if (!io::reportGroups(current).empty()) {
        parts.push_back(DicomPart::Measurements);
    }
    return parts;
}

/// Opens and returns the dialog; if there is no case yet, reports this and returns null.
ui::DicomDialog* DicomController::createDialog(ui::DicomPurpose purpose)
{
    const core::Case& current = document_.current();
    if (!current.vessels.tree || !current.shown().angiogram) {
        emit failed(purpose == ui::DicomPurpose::Send
                        ? tr("Nothing to send yet. Open a vessel tree and an angiogram first.")
                        : tr("There is nothing to export yet. Open a vessel tree and an angiogram first."));
        return nullptr;
    }
    auto* dialog = new ui::DicomDialog(availableParts(), purpose, &dialogParent_);
    dialog->open();
    return dialog;
}

void DicomController::openDialog()
{
    if (const auto* dialog = createDialog(ui::DicomPurpose::Export)) {
        connect(dialog, &ui::DicomDialog::chosen, this, &DicomController::askForFolder,
                Qt::QueuedConnection);   // queued: this dialog closes before the next one opens
    }
}

void DicomController::selectObjectsToSend()
{
    if (const auto* dialog = createDialog(ui::DicomPurpose::Send)) {
        connect(dialog, &ui::DicomDialog::chosen, this, &DicomController::wanted, Qt::QueuedConnection);
    }
}

void DicomController::askForFolder(const ui::DicomExportOptions& choice)
{
    auto* dialog = new QFileDialog(&dialogParent_, tr("Folder for the DICOM objects"), saveFolder(document_.path()));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setFileMode(QFileDialog::Directory);
    dialog->setOption(QFileDialog::ShowDirsOnly);
    connect(dialog, &QFileDialog::fileSelected, this, [this, choice](const QString& folder) { write(choice, folder); });
    dialog->open();
}

DicomExport DicomController::exportOptions(const ui::DicomExportOptions& choice) const
{
    ui::OverlayExportOptions picture;
    picture.widthPx = 0;
    picture.residualColors = ui::Toggle::On;
    picture.identity = choice.identity;
    DicomExport wanted;
    for (const ui::DicomPart part : choice.parts) {
        wanted.kinds.push_back(static_cast<DicomKind>(part));
    }
    wanted.imageOptions = exportController_.overlayOptions(picture);
    wanted.author = observerName().toStdString();
    if (target_.current()) {
        wanted.report = reportMaker(document_.current(), *target_.current(), wanted.imageOptions);
    }
    return wanted;
}

DicomController::ObjectWriter DicomController::makeWriter(const ui::DicomExportOptions& choice) const
{
    return [session = document_.current(), target = target_.current(), wanted = exportOptions(choice)](
               const std::string& folder, const DicomObserver& observe) {
        return writeDicomObjects(session, target ? *target : core::Centerline2d{}, wanted, folder, observe);
    };
}

void DicomController::write(const ui::DicomExportOptions& choice, const QString& folder)
{
    emit started();
    const auto made = std::make_shared<DicomFiles>();
    files_.run(
        [make = makeWriter(choice), folder, made]() -> core::Result<QString> {
            auto files = make(folder.toStdString(), {});
            if (!files) {
                return files.error();
            }
            *made = std::move(files).value();
            return folder;
        },
        [this, made](const core::Result<QString>& outcome) {
            if (!outcome) {
                emit failed(ui::messageText(outcome.error().message));
                return;
            }
            if (!made->paths.empty()) {
                rememberSaveFolder(QString::fromStdString(made->paths.front()));
            }
            QStringList notes;
            for (const core::Message& note : made->notes) {
                notes.push_back(ui::messageText(note));
            }
            emit written(outcome.value(), notes);
        });
}

ReportController::ReportController(CaseDocument& document, TargetProvider& target, ExportController& exportController,
                                   QWidget& dialogParent, QObject* parent)
    : QObject(parent),
      document_(document),
      target_(target),
      exportController_(exportController),
      dialogParent_(dialogParent)
{
}

void ReportController::openDialog()
{
    const core::Case& current = document_.current();
    if (!current.vessels.tree || !current.shown().angiogram || !target_.current()) {
        emit failed(tr("Nothing to report yet. Open vessels and an angiogram first."));
        return;
    }
    // The identity option is off whenever the dialog opens; its state is not remembered.
    auto* dialog = new ui::ReportDialog({ui::Toggle::Off, settings::reportTemplate.read()}, &dialogParent_);
    connect(dialog, &ui::ReportDialog::templateRequested, this, [this, dialog] { askForTemplate(*dialog); });
    connect(dialog, &ui::ReportDialog::templateCopyRequested, this, &ReportController::askForCopyPath);
    connect(dialog, &ui::ReportDialog::chosen, this, &ReportController::askForFile,
            Qt::QueuedConnection);   // queued: this dialog closes before the next one opens
    dialog->open();
}

void ReportController::askForTemplate(ui::ReportDialog& dialog)
{
    const QString last = settings::reportTemplate.read();
    auto* files =
        new QFileDialog(&dialog, tr("Report template"), QFileInfo(last).path(), tr("Templates (*.html *.htm)"));
    files->setAttribute(Qt::WA_DeleteOnClose);
    files->setFileMode(QFileDialog::ExistingFile);
    connect(files, &QFileDialog::fileSelected, &dialog, &ui::ReportDialog::showTemplate);
    files->open();
}

void ReportController::askForCopyPath()
{
    exportController_.askForFile(
        {tr("Save report template"), tr("Templates (*.html)"), QStringLiteral("template.html"), false},
        [](const QString& path) { return writeBytes(builtInReportTemplate(), path); });
}

void ReportController::askForFile(const ui::ReportOptions& choice)
{
    settings::reportTemplate.write(choice.templatePath);
    const core::Case current = caseForExport(document_.current());
    if (!target_.current()) {
        return;   // the target has been removed in the meantime
    }
    ui::OverlayExportOptions picture;
    picture.residualColors = ui::Toggle::On;
    picture.identity = choice.identity;
    exportController_.askForFile(
        {tr("Export report"), tr("Reports (*.pdf *.html)"), QStringLiteral("pdf")},
        [current, target = *target_.current(), imageOptions = exportController_.overlayOptions(picture),
         author = observerName(), typeface = QApplication::font().families(),
         templatePath = choice.templatePath](const QString& path) -> core::Status {
            const auto views = evaluateViews(current, target, imageOptions);
            if (!views) {
                return views.error();
            }
            const bool isHtml = path.endsWith(QLatin1String(".html"), Qt::CaseInsensitive);
            const auto bytes = reportBytes({views.value(), author, typeface, templatePath},
                                           isHtml ? ReportKind::Html : ReportKind::Pdf);
            return bytes ? writeBytes(bytes.value(), path) : bytes.error();
        });
}

}   // namespace angiopose::app
