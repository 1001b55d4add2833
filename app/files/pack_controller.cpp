#include "app/files/pack_controller.h"

#include "app/files/deidentify_controller.h"
#include "app/preferences/save_folder.h"
#include "io/sharing/pack_case.h"
#include "ui/panels/bottom_strip.h"
#include "ui/words/message_text.h"
#include "ui/words/number.h"

#include <QDir>
#include <QFileDialog>

#include <optional>

namespace angiopose::app {
namespace {

std::optional<io::Deidentification> deidentificationFor(const ui::PackChoice& choice)
{
    return choice.identity == ui::Choice::On ? std::nullopt : std::optional(deidentificationOf(choice));
}

}   // namespace

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
                if (error.isStop()) {
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

void PackController::ask()
{
    const core::Case& current = document_.current();
    if (!current.vessels.tree || !current.shown().angiogram) {
        emit failed(tr("There is nothing to pack yet. Open a vessel tree and an angiogram first."));
        return;
    }
    if (job_.isRunning()) {
        emit failed(tr("A case is being packed already. Let that end, or stop it."));
        return;
    }
    auto* dialog = new ui::PackDialog(&dialogParent_);
    connect(dialog, &ui::PackDialog::chosen, this, &PackController::askPath,
            Qt::QueuedConnection);   // one dialog goes, then one comes
    dialog->open();
}

void PackController::askPath(const ui::PackChoice& choice)
{
    const QString proposed = QDir(saveFolder(document_.path())).filePath(QStringLiteral("case.zip"));
    auto* dialog = new QFileDialog(&dialogParent_, tr("Pack case for others"), proposed, tr("Archives (*.zip)"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setDefaultSuffix(QStringLiteral("zip"));
    connect(dialog, &QFileDialog::fileSelected, this, [this, choice](const QString& path) { write(choice, path); });
    dialog->open();
}

void PackController::write(const ui::PackChoice& choice, const QString& path)
{
    archive_ = path;
    strip_.showBusy(tr("Packing …"));
    job_.start([theCase = document_.current(), wish = deidentificationFor(choice),
                archive = path.toStdString()](JobLink<double>& link) -> core::Result<QStringList> {
        const auto pseudonyms = io::Pseudonyms::create();
        if (!pseudonyms) {
            return pseudonyms.error();
        }
        const auto packed = io::packCase(theCase, archive, {wish, pseudonyms.value()},
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
