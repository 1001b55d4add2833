#include "app/files/report_controller.h"

#include "app/files/export_controller.h"
#include "app/preferences/private_mode.h"
#include "app/preferences/settings.h"
#include "app/report/case_report.h"
#include "app/report/report_template.h"
#include "app/words/snapshot_texts.h"
#include "io/support/atomic_file.h"

#include <QApplication>
#include <QFileDialog>
#include <QFileInfo>

namespace angiopose::app {
namespace {

core::Status writeBytes(const QByteArray& bytes, const QString& path)
{
    return io::writeAtomically(path.toStdString(), {bytes.constData(), static_cast<std::size_t>(bytes.size())});
}

}   // namespace

ReportController::ReportController(CaseDocument& document, TargetProvider& target, ExportController& exporting,
                                   QWidget& dialogParent, QObject* parent)
    : QObject(parent), document_(document), target_(target), exporting_(exporting), dialogParent_(dialogParent)
{
}

void ReportController::ask()
{
    const core::Case& current = document_.current();
    if (!current.vessels.tree || !current.shown().angiogram || !target_.current()) {
        emit failed(tr("There is nothing to report yet. Open vessels and an angiogram first."));
        return;
    }
    // Identity is asked for every time: off is no habit that can be forgotten.
    auto* dialog = new ui::ReportDialog({ui::Choice::Off, settings::reportTemplate.read()}, &dialogParent_);
    connect(dialog, &ui::ReportDialog::templateWanted, this, [this, dialog] { askTemplate(*dialog); });
    connect(dialog, &ui::ReportDialog::copyWanted, this, &ReportController::askCopy);
    connect(dialog, &ui::ReportDialog::chosen, this, &ReportController::askFile,
            Qt::QueuedConnection);   // one dialog goes, then one comes
    dialog->open();
}

void ReportController::askTemplate(ui::ReportDialog& dialog)
{
    const QString last = settings::reportTemplate.read();
    auto* files =
        new QFileDialog(&dialog, tr("Report template"), QFileInfo(last).path(), tr("Templates (*.html *.htm)"));
    files->setAttribute(Qt::WA_DeleteOnClose);
    files->setFileMode(QFileDialog::ExistingFile);
    connect(files, &QFileDialog::fileSelected, &dialog, &ui::ReportDialog::showTemplate);
    files->open();
}

void ReportController::askCopy()
{
    exporting_.askFile({tr("Save report template"), tr("Templates (*.html)"), QStringLiteral("template.html"), false},
                       [](const QString& path) { return writeBytes(builtInReportTemplate(), path); });
}

void ReportController::askFile(const ui::ReportChoice& choice)
{
    settings::reportTemplate.write(choice.templatePath);
    const core::Case current = outgoingCase(document_.current());
    if (!target_.current()) {
        return;   // gone meanwhile
    }
    ui::ExportChoice picture;
    picture.residualColors = ui::Choice::On;
    picture.identity = choice.identity;
    exporting_.askFile({tr("Export report"), tr("Reports (*.pdf *.html)"), QStringLiteral("pdf")},
                       [current, target = *target_.current(), look = exporting_.lookOf(picture),
                        author = observerName(), typeface = QApplication::font().families(),
                        templatePath = choice.templatePath](const QString& path) -> core::Status {
                           const auto views = judgedViews(current, target, look);
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
