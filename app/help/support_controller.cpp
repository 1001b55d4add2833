#include "app/help/support_controller.h"

#include "app/messages/catalog.h"
#include "app/preferences/save_folder.h"
#include "app/preferences/settings.h"
#include "core/messages/catalog.h"
#include "io/messages/catalog.h"
#include "io/sharing/case_summary.h"
#include "io/sharing/vocabulary.h"
#include "io/support/crash_dumps.h"
#include "ui/actions/command_table.h"
#include "ui/actions/window_actions.h"
#include "ui/dialogs/support_dialog.h"
#include "ui/panels/bottom_strip.h"
#include "ui/panels/fault_bar.h"
#include "ui/views/gl_driver.h"
#include "ui/words/message_text.h"

#include <QFileDialog>
#include <QGuiApplication>
#include <QLocale>
#include <QScreen>
#include <QSettings>
#include <algorithm>
#include <array>
#include <string>

namespace angiopose::app {
namespace {

/// String settings with a fixed set of values; all other string settings may contain arbitrary text.
constexpr std::array namedSettings{"window/theme", "window/colors", "window/language", "window/mouse"};

/// Words of transient status notes, which are not in the message catalogs.
constexpr std::array allowedStatusWords{
    "opened saved saving written writing packed packing ready stopped finished failed traced tracing registered",
    "could not export open save the file files case pack with without identity converged iterations median trustworthy "
    "reliable unreliable",
    "geöffnet gespeichert geschrieben gepackt bereit gestoppt fertig fehlgeschlagen nicht datei dateien fall"};

QString valueOf(const QString& key, const QVariant& value)
{
    const bool isNamed =
        std::ranges::any_of(namedSettings, [&key](const char* name) { return key == QLatin1String(name); });
    const QString text = value.toString();
    bool isNumber = false;
    text.toDouble(&isNumber);
    const bool isSwitch = text == QLatin1String("true") || text == QLatin1String("false");
    if (isNamed || isSwitch || (isNumber && text.size() < 7)) {
        return text;
    }
    const bool isEmpty =
        !value.isValid() || (text.isEmpty() && value.toByteArray().isEmpty() && value.toStringList().isEmpty());
    return isEmpty ? QStringLiteral("(none)") : QStringLiteral("(set)");
}

/// Returns whether a settings key is one of the program's own, e.g. "files/lastFolder", and may be shown: at most two
/// slashes, otherwise ASCII letters and digits. Other keys may contain names.
bool isOwnKey(const QString& key)
{
    return key.size() < 40 && key.count(QLatin1Char('/')) <= 2 &&
           std::ranges::all_of(key, [](QChar c) { return c.unicode() < 128 && (c.isLetterOrNumber() || c == u'/'); });
}

/// Describes toolkit, screens and renderer in lines of "key: value". Must be called on the GUI thread.
std::string windowFacts()
{
    const ui::GlDriver& driver = ui::glDriver();
    QString facts = QStringLiteral("Qt: %1, built with %2\nplatform: %3\nlocale: %4\n")
                        .arg(QString::fromLatin1(qVersion()), QStringLiteral(QT_VERSION_STR),
                             QGuiApplication::platformName(), QLocale::system().name());
    for (const QScreen* screen : QGuiApplication::screens()) {
        facts += QStringLiteral("screen: %1 x %2 at %3\n")
                     .arg(screen->size().width())
                     .arg(screen->size().height())
                     .arg(screen->devicePixelRatio());
    }
    facts += driver.isAvailable()
                 ? QStringLiteral("OpenGL: %1, %2, %3\n").arg(driver.version, driver.vendor, driver.renderer)
                 : QStringLiteral("OpenGL: none\n");
    facts += QStringLiteral("angiogram renderer: %1\n")
                 .arg(ui::chosenRenderer() == ui::Renderer::Vtk ? QStringLiteral("VTK") : QStringLiteral("processor"));
    return facts.toStdString();
}

/// Lists the preferences. States the values of switches, numbers and settings with a fixed set of values; for other
/// strings, only whether they are set.
std::string settingsText()
{
    const QSettings stored;
    QString text;
    for (const QString& key : stored.allKeys()) {
        if (isOwnKey(key)) {
            text += key + QStringLiteral(": ") + valueOf(key, stored.value(key)) + QLatin1Char('\n');
        }
    }
    return text.toStdString();
}

/// Collects all words of the message catalogs, in English and in the UI language, and of the menus.
io::Vocabulary knownProgramWords()
{
    io::Vocabulary words;
    for (const auto& catalog : {core::messageCatalog(), io::messageCatalog(), messageCatalog()}) {
        for (const core::MessageEntry* entry : catalog) {
            words.add(entry->english);
            words.add(ui::messageText(core::Message(*entry, {})).toStdString());
        }
    }
    for (const ui::MenuRows& menu : ui::CommandTable::menus()) {
        for (const ui::CommandRow& row : menu.commands) {
            words.add(row.text);
        }
    }
    for (const char* each : allowedStatusWords) {
        words.add(each);
    }
    words.add("name path file uid date");   // names of the placeholders for redacted text
    return words;
}

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
      collectJob_({[this](const SharedTexts& texts) { show(texts); },
                   [this](const core::Error& error) { emit failed(ui::messageText(error.message)); }}),
      writeJob_({[this](const QString& path) { emit written(path); },
                 [this](const core::Error& error) { emit failed(ui::messageText(error.message)); }})
{
    connect(ui_.actions[ui::Command::SupportBundle], &QAction::triggered, this, &SupportController::collect);
    connect(&ui_.faults, &ui::FaultBar::bundleRequested, this, &SupportController::collect);
    connect(&document_, &CaseDocument::changed, this, &SupportController::rememberCase);
}

void SupportController::reportCrash()
{
    const auto dumps = io::crashDumps("angiopose");
    if (dumps.empty()) {
        return;
    }
    const QString name = QString::fromStdString(dumps.front().filename().string());
    if (name != settings::lastReportedCrash.read()) {
        settings::lastReportedCrash.write(name);
        ui_.faults.showFault(QString::fromStdString(dumps.front().string()));
    }
}

/// Adds the identifiers of the open case to the redaction, because the log covers every case of the session. Does
/// nothing unless the inputs have changed; text edited by the user is added when the bundle is created.
void SupportController::rememberCase()
{
    const QStringList inputs = inputsOf(document_);
    if (inputs == latestInputs_) {
        return;
    }
    latestInputs_ = inputs;
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
    for (const ui::LoggedMessage& reported : ui_.strip.reported().all()) {
        const qint64 seconds = sessionStart_.secsTo(reported.time);
        log += QStringLiteral("+%1:%2 ").arg(seconds / 60).arg(seconds % 60, 2, 10, QLatin1Char('0')).toStdString() +
               reported.text.toStdString() + '\n';
    }
    return log;
}

void SupportController::collect()
{
    if (collectJob_.isRunning()) {
        return;
    }
    io::addIdentifiers(document_.current(), redaction_);
    collectJob_.start([facts = windowFacts(), preferences = settingsText(), log = logText(),
                       words = knownProgramWords(), session = document_.current(), redaction = redaction_,
                       inputs = inputs_](JobLink<double>&) mutable -> core::Result<SharedTexts> {
        for (const QString& path : inputs) {
            io::addIdentifiersOfFile(path.toStdString(), redaction);
        }
        auto texts = io::diagnosticFiles(facts);
        texts.push_back({"settings.txt", preferences});
        texts.push_back({"case.txt", io::caseSummary(session)});
        texts = io::redact(std::move(texts), redaction);
        texts.push_back({"log.txt", words.keepKnownWords(redaction.redact(log))});
        return SharedTexts(std::make_shared<const std::vector<io::SupportFile>>(std::move(texts)));
    });
}

void SupportController::show(const SharedTexts& texts)
{
    std::vector<ui::SupportPart> parts;
    for (const io::SupportFile& each : *texts) {
        parts.push_back({QString::fromStdString(each.name), QString::fromStdString(each.text)});
    }
    auto* dialog = new ui::SupportDialog(std::move(parts), &ui_.dialogParent);
    connect(
        dialog, &ui::SupportDialog::saveRequested, this, [this, texts] { askForPath(texts); }, Qt::QueuedConnection);
    dialog->open();
}

void SupportController::askForPath(const SharedTexts& texts)
{
    auto* dialog =
        new QFileDialog(&ui_.dialogParent, tr("Save support bundle"),
                        suggestedPath({}, QStringLiteral("angiopose-support.zip")), tr("ZIP archives (*.zip)"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setDefaultSuffix(QStringLiteral("zip"));
    connect(dialog, &QFileDialog::fileSelected, this, [this, texts](const QString& path) { write(texts, path); });
    dialog->open();
}

void SupportController::write(const SharedTexts& texts, const QString& path)
{
    writeJob_.start([texts, path](JobLink<double>&) -> core::Result<QString> {
        const core::Status written = io::writeSupportBundle(*texts, path.toStdString());
        return written ? core::Result<QString>(path) : written.error();
    });
}

}   // namespace angiopose::app
