#include "app/files/pack_controller.h"

#include "app/preferences/save_folder.h"
#include "io/sharing/pack_case.h"
#include "ui/words/message_text.h"

#include <QDir>
#include <QFileDialog>

#include <memory>
#include <optional>

namespace angiopose::app {
namespace {

std::optional<io::Deidentification> deidentificationFor(const ui::PackChoice& choice)
{
    if (choice.identity == ui::Choice::On) {
        return {};
    }
    return io::Deidentification{
        choice.shiftedDates == ui::Choice::On ? io::KeptDates::Shifted : io::KeptDates::None,
        choice.blackedOut == ui::Choice::On ? io::DrawnLetters::BlackedOut : io::DrawnLetters::Told,
        choice.pseudonym.trimmed().toStdString()};
}

}   // namespace

PackController::PackController(CaseDocument& document, QWidget& dialogParent, QObject* parent)
    : QObject(parent), document_(document), dialogParent_(dialogParent)
{
}

void PackController::ask()
{
    const core::Case& current = document_.current();
    if (!current.vessels.tree || !current.shown().angiogram) {
        emit failed(tr("There is nothing to pack yet. Open a vessel tree and an angiogram first."));
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
    emit started();
    const auto notes = std::make_shared<QStringList>();
    files_.run(
        [theCase = document_.current(), wish = deidentificationFor(choice), path, notes]() -> core::Result<QString> {
            const auto pseudonyms = io::Pseudonyms::create();
            const auto packed =
                pseudonyms ? io::packCase(theCase, path.toStdString(), {wish, pseudonyms.value()}) : pseudonyms.error();
            if (!packed) {
                return packed.error();
            }
            for (const core::Message& note : packed.value()) {
                notes->push_back(ui::messageText(note));
            }
            return path;
        },
        [this, notes](const core::Result<QString>& outcome) {
            if (!outcome) {
                emit failed(ui::messageText(outcome.error().message));
                return;
            }
            rememberSaveFolder(outcome.value());
            emit written(outcome.value(), *notes);
        });
}

}   // namespace angiopose::app
