#include "app/files/deidentify_controller.h"

#include "app/preferences/save_folder.h"
#include "app/preferences/settings.h"
#include "io/sharing/pack_case.h"
#include "ui/panels/bottom_strip.h"
#include "ui/words/language.h"
#include "ui/words/message_text.h"
#include "ui/words/number.h"

#include <QDir>
#include <QFileDialog>
#include <optional>

namespace angiopose::app {
namespace {

std::optional<io::DeidentificationOptions> deidentificationFor(const ui::ShareOptions& options)
{
    return options.identity == ui::Toggle::On ? std::nullopt : std::optional(deidentificationOf(options));
}

}   // namespace

io::DeidentificationOptions deidentificationOf(const ui::ShareOptions& options)
{
    return {options.shiftedDates == ui::Toggle::On ? io::DatePolicy::Shifted : io::DatePolicy::None,
            options.maskText == ui::Toggle::On ? io::BurnedInTextPolicy::Masked : io::BurnedInTextPolicy::Reported,
            options.pseudonym.trimmed().toStdString()};
}

DeidentifyController::DeidentifyController(ui::BottomStrip& strip, QWidget& dialogParent, QObject* parent)
    : QObject(parent),
      strip_(strip),
      dialogParent_(dialogParent),
      job_({[this](const io::DeidentifiedFiles& done) { reportOutcome(done); },
            [this](const core::Error& error) { reportFailure(error); },
            [this](double fraction) {
                strip_.showProgress(tr("De-identifying: %1 %").arg(ui::numberText(100.0 * fraction, 0)), fraction);
            }})
{
    connect(&strip_, &ui::BottomStrip::stopRequested, this, [this] { job_.requestStop(); });
}

void DeidentifyController::openDialog()
{
    if (job_.isRunning()) {
        emit failed(tr("A de-identification is already running. Wait for it to finish, or stop it."));
        return;
    }
    dialog_ = new ui::DeidentifyDialog(&dialogParent_);
    connect(dialog_, &ui::DeidentifyDialog::addFilesRequested, this, &DeidentifyController::askForFiles);
    connect(dialog_, &ui::DeidentifyDialog::addFolderRequested, this, &DeidentifyController::askForFolder);
    connect(dialog_, &ui::DeidentifyDialog::outputFolderRequested, this, &DeidentifyController::askForOutputFolder);
    connect(dialog_, &ui::DeidentifyDialog::chosen, this, &DeidentifyController::write);
    dialog_->open();
}

void DeidentifyController::askForFiles()
{
    auto* files = new QFileDialog(dialog_, tr("Files to de-identify"), settings::lastFolder.read());
    files->setAttribute(Qt::WA_DeleteOnClose);
    files->setFileMode(QFileDialog::ExistingFiles);
    connect(files, &QFileDialog::filesSelected, dialog_, &ui::DeidentifyDialog::addPaths);
    files->open();
}

void DeidentifyController::askForFolder()
{
    auto* folder = new QFileDialog(dialog_, tr("Folder to de-identify"), settings::lastFolder.read());
    folder->setAttribute(Qt::WA_DeleteOnClose);
    folder->setFileMode(QFileDialog::Directory);
    connect(folder, &QFileDialog::fileSelected, dialog_, [this](const QString& path) { dialog_->addPaths({path}); });
    folder->open();
}

void DeidentifyController::askForOutputFolder()
{
    auto* folder = new QFileDialog(dialog_, tr("Output folder"), saveFolder({}));
    folder->setAttribute(Qt::WA_DeleteOnClose);
    folder->setFileMode(QFileDialog::Directory);
    connect(folder, &QFileDialog::fileSelected, dialog_, &ui::DeidentifyDialog::setOutputFolder);
    folder->open();
}

void DeidentifyController::write(const ui::DeidentifyOptions& options)
{
    std::vector<std::string> paths;
    for (const QString& path : options.paths) {
        paths.push_back(path.toStdString());
    }
    output_ = options.outputFolder;
    strip_.showBusy(tr("De-identifying…"));
    job_.start([paths, output = output_.toStdString(), requested = deidentificationOf(options.sharing)](
                   JobLink<double>& link) -> core::Result<io::DeidentifiedFiles> {
        const auto pseudonyms = io::Pseudonyms::create();
        if (!pseudonyms) {
            return pseudonyms.error();
        }
        return io::deidentifyFiles(paths, output, requested, pseudonyms.value(),
                                   [&link](double fraction) { return link.tell(fraction); });
    });
}

void DeidentifyController::reportOutcome(const io::DeidentifiedFiles& done)
{
    strip_.showIdle(tr("Ready"));
    rememberSaveFolder(output_);
    QStringList summary{
        tr("De-identified files: %1, in %2.").arg(ui::numberText(static_cast<double>(done.written), 0), output_)};
    if (!done.warnings.empty()) {
        summary << ui::messagesText(done.warnings);
    }
    emit written(output_, ui::joinSentences(summary));
    if (!done.skipped.empty()) {
        QStringList lines;
        for (const core::Message& skipped : done.skipped) {
            lines << ui::messageText(skipped);
        }
        emit partlyRejected(
            tr("%1 files were de-identified; %2 were not, for the reasons listed below. The output folder is %3.")
                .arg(ui::numberText(static_cast<double>(done.written), 0),
                     ui::numberText(static_cast<double>(done.skipped.size()), 0), output_),
            lines.join(QLatin1Char('\n')));
    }
}

void DeidentifyController::reportFailure(const core::Error& error)
{
    strip_.showIdle(tr("Ready"));
    if (error.isCancellation()) {
        emit stopped();
    } else {
        emit failed(ui::messageText(error.message));
    }
}

PackController::PackController(CaseDocument& document, ui::BottomStrip& strip, QWidget& dialogParent, QObject* parent)
    : QObject(parent),
      document_(document),
      strip_(strip),
      dialogParent_(dialogParent),
      job_({[this](const QStringList& notes) {
                strip_.showIdle(tr("Ready"));
                rememberSaveFolder(archive_);
                emit written(archive_, notes);
            },
            [this](const core::Error& error) {
                strip_.showIdle(tr("Ready"));
                if (error.isCancellation()) {
                    emit stopped();
                } else {
                    emit failed(ui::messageText(error.message));
                }
            },
            [this](double fraction) {
                strip_.showProgress(tr("Packing: %1 %").arg(ui::numberText(100.0 * fraction, 0)), fraction);
            }})
{
    connect(&strip_, &ui::BottomStrip::stopRequested, this, [this] { job_.requestStop(); });
}

void PackController::openDialog()
{
    const core::Case& current = document_.current();
    if (!current.vessels.tree || !current.shown().angiogram) {
        emit failed(tr("Nothing to share yet. Open a vessel tree and an angiogram first."));
        return;
    }
    if (job_.isRunning()) {
        emit failed(tr("A case is already being packed. Wait for it to finish, or stop it."));
        return;
    }
    auto* dialog = new ui::PackDialog(&dialogParent_);
    connect(dialog, &ui::PackDialog::chosen, this, &PackController::askForPath,
            Qt::QueuedConnection);   // queued: this dialog closes before the next one opens
    dialog->open();
}

void PackController::askForPath(const ui::ShareOptions& options)
{
    const QString proposed = QDir(saveFolder(document_.path())).filePath(QStringLiteral("case.zip"));
    auto* dialog = new QFileDialog(&dialogParent_, tr("Share case as ZIP"), proposed, tr("ZIP archives (*.zip)"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setDefaultSuffix(QStringLiteral("zip"));
    connect(dialog, &QFileDialog::fileSelected, this, [this, options](const QString& path) { write(options, path); });
    dialog->open();
}

void PackController::write(const ui::ShareOptions& options, const QString& path)
{
    archive_ = path;
    strip_.showBusy(tr("Packing…"));
    job_.start([session = document_.current(), request = deidentificationFor(options),
                archive = path.toStdString()](JobLink<double>& link) -> core::Result<QStringList> {
        const auto pseudonyms = io::Pseudonyms::create();
        if (!pseudonyms) {
            return pseudonyms.error();
        }
        const auto packed = io::packCase(session, archive, {request, pseudonyms.value()},
                                         [&link](double fraction) { return link.tell(fraction); });
        if (!packed) {
            return packed.error();
        }
        QStringList notes;
        for (const core::Message& note : packed.value()) {
            notes << ui::messageText(note);
        }
        return notes;
    });
}

}   // namespace angiopose::app
