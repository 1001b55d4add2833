#include "app/files/privacy_controller.h"

#include "app/files/recent_cases.h"
#include "app/preferences/private_mode.h"
#include "app/preferences/save_folder.h"
#include "app/preferences/settings.h"
#include "ui/dialogs/message_dialog.h"
#include "ui/words/message_text.h"
#include "ui/words/retranslation.h"

#include <QAction>
#include <QFileDialog>

namespace angiopose::app {
namespace {

void addPath(const std::string& path, QStringList& paths)
{
    const QString added = QString::fromStdString(path);
    if (!added.isEmpty() && !paths.contains(added)) {
        paths << added;
    }
}

}   // namespace

PrivacyController::PrivacyController(QAction& mode, QWidget& dialogParent, QObject* parent)
    : QObject(parent), privateModeAction_(mode), dialogParent_(dialogParent)
{
    privateModeAction_.setChecked(isPrivate());
    ui::withToolTip(&privateModeAction_, [] {
        return tr("Stores no list or thumbnails of recent cases and no folders, and shows no names in the title bar.");
    });
    connect(&privateModeAction_, &QAction::triggered, this, &PrivacyController::choose);
}

PrivacyController::~PrivacyController()
{
    if (isPrivate()) {
        clearFileDialogHistory();
    }
}

void PrivacyController::choose(bool on)
{
    if (!on) {
        turnOff();
        return;
    }
    auto* question = new ui::QuestionDialog(
        {tr("Turn on private mode?"),
         tr("The list of recent cases (including pinned ones), their thumbnails, and all stored folders and names will "
            "be permanently deleted. No such data will be stored until private mode is turned off. Unsaved work is "
            "still autosaved; the copies are deleted when the case is closed."),
         {}},
        {tr("Turn on"), tr("Cancel")}, &dialogParent_);
    question->setObjectName(QStringLiteral("privacyDialog"));
    connect(question, &ui::QuestionDialog::answered, this, [this](int verb) {
        if (verb == 0) {
            turnOn();
        } else {
            privateModeAction_.setChecked(false);
        }
    });
    question->open();
}

void PrivacyController::turnOn()
{
    settings::privateMode.write(true);
    clearStoredData();
    pruneCaseThumbnails({});
    ui::retranslate();
    emit changed();
}

void PrivacyController::turnOff()
{
    settings::privateMode.write(false);
    ui::retranslate();
    emit changed();
}

AuditController::AuditController(const CaseDocument& document, QAction& keep, QWidget& dialogParent, QObject* parent)
    : QObject(parent), document_(document), auditAction_(keep), dialogParent_(dialogParent)
{
    auditAction_.setChecked(!auditPath().isEmpty());
    auditAction_.setEnabled(
        io::auditFileFromEnvironment().empty());   // an audit file set by the environment cannot be switched off here
    ui::withToolTip(&auditAction_, [] {
        const QString kept = auditPath();
        return kept.isEmpty()
                   ? tr("Writes one line for each file opened, saved or exported: time, user, and SHA-256 of the file.")
                   : tr("Written to %1").arg(kept);
    });
    connect(&auditAction_, &QAction::triggered, this, &AuditController::choose);
}

void AuditController::choose(bool on)
{
    if (!on) {
        settings::auditFile.write({});
        ui::retranslate();
        return;
    }
    auditAction_.setChecked(false);   // stays off until a file has been chosen
    auto* dialog = new QFileDialog(&dialogParent_, tr("Write audit log"),
                                   suggestedPath({}, QStringLiteral("audit.jsonl")), tr("Audit logs (*.jsonl)"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setOption(QFileDialog::DontConfirmOverwrite);   // the file is appended to, not overwritten
    dialog->setDefaultSuffix(QStringLiteral("jsonl"));
    connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& chosen) {
        settings::auditFile.write(chosen);
        auditAction_.setChecked(true);
        ui::retranslate();
    });
    dialog->open();
}

void AuditController::note(io::AuditEvent event, const QStringList& paths)
{
    const QString audit = auditPath();
    if (audit.isEmpty()) {
        return;
    }
    io::AuditRecord record{event, "angiopose", {}};
    for (const QString& each : paths) {
        record.paths.push_back(each.toStdString());
    }
    files_.run(
        [audit, record]() -> core::Result<QString> {
            const core::Status written = io::recordAudit(audit.toStdString(), record);
            return written ? core::Result<QString>(audit) : written.error();
        },
        [this](const core::Result<QString>& outcome) {
            if (!outcome) {
                emit failed(ui::messageText(outcome.error().message));
            }
        });
}

void AuditController::noteOpened()
{
    const core::Case& current = document_.current();
    QStringList paths;
    addPath(document_.path().toStdString(), paths);
    for (const core::InputFile* file : {&current.vessels.file, &current.vessels.scanFile}) {
        addPath(file->path, paths);
    }
    for (const core::View& view : current.views) {
        addPath(view.imageFile.path, paths);
        addPath(view.target.file.path, paths);
    }
    note(io::AuditEvent::Opened, paths);
}

void AuditController::noteCase(io::AuditEvent event)
{
    note(event, document_.path().isEmpty() ? QStringList() : QStringList{document_.path()});
}

}   // namespace angiopose::app
