#include "app/files/open_notes.h"

#include "core/case/case_patients.h"
#include "io/opening/assemble_case.h"
#include "ui/actions/key_hint.h"
#include "ui/words/message_text.h"
#include "ui/words/number.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>

namespace angiopose::app {
namespace {

struct NoteWords {
    Q_DECLARE_TR_FUNCTIONS(angiopose::app::OpenNotes)
};

}   // namespace

QString namesOf(const QStringList& paths)
{
    QStringList names;
    for (const QString& path : paths) {
        names << QFileInfo(QDir::cleanPath(path)).fileName();
    }
    return names.join(QStringLiteral(", "));
}

QStringList openNotes(const io::LoadedInputs& inputs, const core::Case& opened)
{
    QStringList notes;
    for (const core::Message& warning : inputs.warnings) {
        notes << ui::messageText(warning);
    }
    if (!inputs.loadedCase && inputs.vesselInput.unitMm > 0.0) {
        notes << NoteWords::tr("File unit: %1 mm, as selected.").arg(ui::briefNumber(inputs.vesselInput.unitMm, 6));
    }
    if (!inputs.loadedCase) {   // for a complete case file, the images were compared while loading
        for (const core::Message& mismatch : core::findMismatch(opened)) {
            notes << ui::messageText(mismatch);
        }
    }
    return notes;
}

QStringList scanNotes(const io::LoadedInputs& inputs, const core::Case& opened)
{
    if (inputs.volume && !opened.vessels.tree) {
        return {NoteWords::tr("No vessels have been traced in the scan yet. Place a seed or set the threshold in the "
                              "slices (%1), then trace.")
                    .arg(ui::keyOf(ui::Command::SlicesLarge))};
    }
    const bool isBeside = inputs.volume && !inputs.tree && opened.vessels.tree;
    return isBeside && !io::isInsideScan(inputs.volume->geometry, *opened.vessels.tree)
               ? QStringList(NoteWords::tr("The vessels lie outside this scan: it may be a different scan or use a "
                                           "different coordinate system."))
               : QStringList();
}

}   // namespace angiopose::app
