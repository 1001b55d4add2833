#include "app/help/support_controller.h"

#include "app/help/support_texts.h"
#include "app/preferences/save_folder.h"
#include "app/preferences/settings.h"
#include "io/sharing/case_identifiers.h"
#include "io/sharing/case_summary.h"
#include "io/support/crash_dumps.h"
#include "ui/actions/window_actions.h"
#include "ui/dialogs/support_dialog.h"
#include "ui/panels/bottom_strip.h"
#include "ui/panels/fault_bar.h"
#include "ui/words/message_text.h"

#include <QFileDialog>

namespace angiopose::app {
namespace {

QStringList inputsOf(const CaseDocument& document)
{
    const core::Case& current = document.current();
    QStringList paths{document.path(), QString::fromStdString(current.vessels.file.path),
                      QString::fromStdString(current.vessels.scanFile.path)};
    for (const core::View& view : current.views) {
        paths << QString::fromStdString(view.imageFile.path) << QString::fromStdString(view.caseFile.path);
    }
    paths.removeAll(QString());
    return paths;
}

}   // namespace

SupportController::SupportController(const CaseDocument& document, const Ui& ui, QObject* parent)
    : QObject(parent),
      document_(document),
      ui_(ui),
      texts_({[this](const SharedTexts& texts) { show(texts); },
              [this](const core::Error& error) { emit failed(ui::messageText(error.message)); }}),
      writing_({[this](const QString& path) { emit written(path); },
                [this](const core::Error& error) { emit failed(ui::messageText(error.message)); }})
{
    connect(ui_.actions[ui::Command::SupportBundle], &QAction::triggered, this, &SupportController::prepare);
    connect(&ui_.faults, &ui::FaultBar::bundleRequested, this, &SupportController::prepare);
    connect(&document_, &CaseDocument::changed, this, &SupportController::rememberCase);
}

void SupportController::tellOfFault()
{
    const auto dumps = io::crashDumps("angiopose");
    if (dumps.empty()) {
        return;
    }
    const QString name = QString::fromStdString(dumps.front().filename().string());
    if (name != settings::seenFault.read()) {
        settings::seenFault.write(name);
        ui_.faults.showFault(QString::fromStdString(dumps.front().string()));
    }
}

/// Of every case that was open in this session, for the log speaks of all of them. Only where inputs are others: edits
/// of what is typed are taken up when the bundle is made.
void SupportController::rememberCase()
{
    const QStringList inputs = inputsOf(document_);
    if (inputs == newest_) {
        return;
    }
    newest_ = inputs;
    io::addIdentifiers(document_.current(), redaction_);
    for (const QString& path : inputs) {
        if (!inputs_.contains(path)) {
            inputs_ << path;
        }
    }
}

std::string SupportController::logText() const
{
    std::string log;
    for (const ui::ToldMessage& told : ui_.strip.told().all()) {
        const qint64 seconds = begun_.secsTo(told.time);
        log += QStringLiteral("+%1:%2 ").arg(seconds / 60).arg(seconds % 60, 2, 10, QLatin1Char('0')).toStdString() +
               told.text.toStdString() + '\n';
    }
    return log;
}

void SupportController::prepare()
{
    if (texts_.isRunning()) {
        return;
    }
    io::addIdentifiers(document_.current(), redaction_);
    texts_.start([facts = windowFacts(), preferences = settingsText(), log = logText(), words = wordsOfProgram(),
                  theCase = document_.current(), redaction = redaction_,
                  inputs = inputs_](JobLink<double>&) mutable -> core::Result<SharedTexts> {
        for (const QString& path : inputs) {
            io::addIdentifiersOfFile(path.toStdString(), redaction);
        }
        auto texts = io::programTexts(facts);
        texts.push_back({"settings.txt", preferences});
        texts.push_back({"case.txt", io::caseSummary(theCase)});
        texts = io::cleaned(std::move(texts), redaction);
        texts.push_back({"log.txt", words.only(redaction.cleaned(log))});
        return SharedTexts(std::make_shared<const std::vector<io::SupportText>>(std::move(texts)));
    });
}

void SupportController::show(const SharedTexts& texts)
{
    std::vector<ui::SupportPart> parts;
    for (const io::SupportText& each : *texts) {
        parts.push_back({QString::fromStdString(each.name), QString::fromStdString(each.text)});
    }
    auto* dialog = new ui::SupportDialog(std::move(parts), &ui_.dialogParent);
    connect(
        dialog, &ui::SupportDialog::saveRequested, this, [this, texts] { askPath(texts); }, Qt::QueuedConnection);
    dialog->open();
}

void SupportController::askPath(const SharedTexts& texts)
{
    auto* dialog = new QFileDialog(&ui_.dialogParent, tr("Save support bundle"),
                                   suggestedPath({}, QStringLiteral("angiopose-support.zip")), tr("Archives (*.zip)"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setDefaultSuffix(QStringLiteral("zip"));
    connect(dialog, &QFileDialog::fileSelected, this, [this, texts](const QString& path) { write(texts, path); });
    dialog->open();
}

void SupportController::write(const SharedTexts& texts, const QString& path)
{
    writing_.start([texts, path](JobLink<double>&) -> core::Result<QString> {
        const core::Status written = io::writeSupportBundle(*texts, path.toStdString());
        return written ? core::Result<QString>(path) : written.error();
    });
}

}   // namespace angiopose::app
