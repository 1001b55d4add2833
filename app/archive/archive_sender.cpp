#include "app/archive/archive_sender.h"

#include "app/archive/archive_nodes.h"
#include "app/archive/archive_words.h"
#include "app/archive/network_wait.h"
#include "io/support/scratch_folder.h"
#include "ui/archive/send_dialog.h"
#include "ui/archive/transfer_line.h"
#include "ui/words/language.h"
#include "ui/words/message_text.h"

#include <QDir>

namespace angiopose::app {

/// Created objects and their folder. Only one worker uses them at a time; the last owner removes the folder.
struct ArchiveSender::CreatedObjects {
    ObjectWriter objectWriter;
    io::ScratchFolder folder{QDir(QDir::tempPath()).filePath(QStringLiteral("objects")).toStdString()};
    core::Messages notes;   ///< messages from creating the objects
    bool isMade = false;
};

ArchiveSender::ArchiveSender(ArchiveList& list, QWidget& dialogParent, QObject* parent)
    : QObject(parent),
      list_(list),
      dialogParent_(dialogParent),
      job_({[this](const io::TransferReport& report) { showReport(report); },
            [this](const core::Error& error) { showError(error); },
            [this](const Progress& progress) { follow(progress); }})
{
}

void ArchiveSender::openDialog(const ObjectWriter& objectWriter)
{
    created_ = std::make_shared<CreatedObjects>();
    created_->objectWriter = objectWriter;
    dialog_ = new ui::SendDialog(&dialogParent_);
    nodes_ = new ArchiveNodes(list_, {dialog_->nodes(), dialog_->line(), *dialog_}, dialog_);
    connect(nodes_, &ArchiveNodes::archiveSelected, dialog_, &ui::SendDialog::showNode);
    connect(dialog_, &ui::SendDialog::sendRequested, this, &ArchiveSender::send);
    connect(&dialog_->line(), &ui::TransferLine::stopRequested, this, [this] {
        if (job_.isRunning()) {
            job_.requestStop();
            dialog_->line().showBusy(tr("Stopping…"));
        }
    });
    connect(dialog_, &QDialog::finished, this, [this] {
        job_.drop();
        created_.reset();
    });
    list_.read();
    dialog_->open();
}

void ArchiveSender::send()
{
    const auto node = nodes_->node();
    if (!node) {
        return;
    }
    dialog_->line().showBusy(tr("Creating the objects…"));
    job_.start([created = created_, node = *node](JobLink<Progress>& link) { return work(*created, node, link); });
}

core::Result<io::TransferReport> ArchiveSender::work(CreatedObjects& created, const io::ArchiveNode& node,
                                                     JobLink<Progress>& link)
{
    const std::string folder = created.folder.path().string();
    if (!created.isMade) {
        if (auto there = created.folder.make(); !there) {
            return there.error();
        }
        const auto files = created.objectWriter(folder, [&link](double fraction) {
            return link.tell({fraction, io::ArchiveProgress()});
        });
        if (!files) {
            return files.error();
        }
        created.notes = files.value().notes;
        created.isMade = true;
    }
    const ThreadPoolRelease waiting;
    return io::sendToArchive(node, io::ArchiveProtocol::Default, {folder},
                             [&link](const io::ArchiveProgress& progress) {
                                 return link.tell({1.0, progress});
                             });
}

void ArchiveSender::follow(const Progress& progress)
{
    if (!dialog_) {
        return;
    }
    if (progress.sending.all == 0) {
        dialog_->line().showProgress(tr("Creating the objects…"), static_cast<qsizetype>(1000.0 * progress.created),
                                     1000);
        return;
    }
    dialog_->line().showProgress(tr("Sent: %1 of %2 objects, %3")
                                     .arg(progress.sending.objects)
                                     .arg(progress.sending.all)
                                     .arg(byteSizeText(progress.sending.bytes)),
                                 static_cast<qsizetype>(progress.sending.objects),
                                 static_cast<qsizetype>(progress.sending.all));
}

void ArchiveSender::showReport(const io::TransferReport& report)
{
    if (!dialog_) {
        return;
    }
    const QString name = dialog_->nodes().node();
    const std::size_t there = report.transferred + report.duplicates;
    if (report.isComplete()) {
        const QString summary =
            tr("%1 received all objects: %2 (%3).").arg(name, QString::number(there), byteSizeText(report.bytes));
        dialog_->showSent(summary);
        QStringList notes;
        for (const core::Message& note : created_->notes) {
            notes << ui::messageText(note);
        }
        emit sent(summary, notes);
        return;
    }
    const QString count = tr("%1 of %2 objects were delivered.").arg(there).arg(report.all);
    if (report.end && report.end->isCancellation()) {
        dialog_->line().showHint(ui::joinSentences({tr("Stopped."), count, tr("Send again to transfer the rest.")}));
        return;
    }
    QStringList summary;
    if (report.end) {
        summary << ui::messageText(report.end->message);
    }
    for (const core::Message& problem : report.problems) {
        summary << ui::messageText(problem);
    }
    dialog_->line().showProblem((summary << count).join(u'\n'));
}

void ArchiveSender::showError(const core::Error& error)
{
    if (!dialog_) {
        return;
    }
    if (error.isCancellation()) {
        dialog_->line().showHint(tr("Stopped. Nothing was sent."));
    } else {
        dialog_->line().showProblem(ui::messageText(error.message));
    }
}

}   // namespace angiopose::app
