#include "app/archive/archive_controller.h"

#include "app/archive/archive_nodes.h"
#include "app/archive/archive_retrieval.h"
#include "app/archive/archive_settings.h"
#include "app/archive/storage_scp_service.h"
#include "ui/archive/archive_dialog.h"
#include "ui/archive/receive_line.h"
#include "ui/archive/search_fields.h"
#include "ui/archive/send_dialog.h"
#include "ui/archive/transfer_line.h"
#include "ui/words/message_text.h"

#include <QAction>

namespace angiopose::app {

ArchiveController::ArchiveController(const Ui& ui, QObject* parent) : QObject(parent), ui_(ui)
{
    connect(&scpService_, &StorageScpService::changed, this, &ArchiveController::showPort);
    connect(&scpService_, &StorageScpService::auditFailed, this, &ArchiveController::auditFailed);
    connect(&scpService_, &StorageScpService::closed, this, [this](const QString& problem) {
        showPort();
        if (dialog_ && !problem.isEmpty()) {
            dialog_->line().showProblem(problem);
        } else if (!problem.isEmpty()) {
            emit reported(problem);
        }
    });
}

void ArchiveController::show()
{
    if (dialog_) {
        dialog_->raise();
        dialog_->activateWindow();
        return;
    }
    dialog_ = new ui::ArchiveDialog(&ui_.dialogParent);
    dialog_->addAction(&ui_.hideIdentity);
    connectParts();
    connectScpService();
    list_.read();
    dialog_->open();
    dialog_->fields().focusFirst();
}

void ArchiveController::connectParts()
{
    ui::ArchiveDialog& dialog = *dialog_;
    nodes_ = new ArchiveNodes(list_, {dialog.nodes(), dialog.line(), dialog}, dialog_);
    finder_ = new ArchiveFinder(dialog, searchResults_, ui_.hideIdentity, dialog_);
    retrieval_ = new ArchiveRetrieval(dialog, dialog_);
    auto* cache = new ArchiveCache(list_, {dialog.cache(), dialog.line(), dialog}, dialog_);
    connect(nodes_, &ArchiveNodes::archiveSelected, finder_, [this] { finder_->selectArchive(nodes_->node()); });
    connect(dialog_, &ui::ArchiveDialog::retrieveRequested, this, &ArchiveController::retrieve);
    connect(retrieval_, &ArchiveRetrieval::ended, cache, &ArchiveCache::measure);
    const auto offerRetrieved = [this] { offerToOpen(retrieval_->folders(), dialog_->nodes().node()); };
    connect(retrieval_, &ArchiveRetrieval::retrieved, this, offerRetrieved);
    connect(retrieval_, &ArchiveRetrieval::auditFailed, this, &ArchiveController::auditFailed);
    connect(dialog_, &ui::ArchiveDialog::partialSeriesRequested, this, offerRetrieved);
}

void ArchiveController::connectScpService()
{
    ui::ReceiveLine& line = dialog_->receive();
    line.showPort(settings::receivePort.read(), settings::receiveTitle.read());
    showPort();
    connect(&line, &ui::ReceiveLine::toggled, this, &ArchiveController::setScpEnabled);
    connect(&line, &ui::ReceiveLine::securityRequested, new StorageScpSecurity(*dialog_, dialog_),
            &StorageScpSecurity::openDialog);
    connect(&line, &ui::ReceiveLine::openRequested, this,
            [this] { offerToOpen(scpService_.folders(), tr("objects received on port %1").arg(scpService_.port())); });
}

void ArchiveController::retrieve()
{
    const auto node = nodes_->node();
    const auto requests = finder_->requests();
    if (node && !requests.empty()) {
        retrieval_->start(*node, list_.settings(), requests);
    }
}

/// Closes the archive dialog and then offers the received images, since opening these may show another dialog.
void ArchiveController::offerToOpen(const QStringList& folders, const QString& name)
{
    dialog_->accept();
    QMetaObject::invokeMethod(
        this, [this, folders, name] { emit retrieved(folders, name); }, Qt::QueuedConnection);
}

void ArchiveController::setScpEnabled(bool isOn)
{
    if (!isOn) {
        scpService_.close();
        return;
    }
    const ui::ReceiveLine& line = dialog_->receive();
    settings::receivePort.write(line.port());
    settings::receiveTitle.write(line.title());
    scpService_.open(
        {receiverOptions(line.port(), line.title()), list_.settings().cache(), list_.settings().cacheBytes});
    showPort();
}

QString ArchiveController::scpStatusText() const
{
    const StorageScpService::ReceivedObjects& received = scpService_.received();
    QStringList words;
    if (received.objects > 0) {
        words << tr("Objects received: %1").arg(received.objects);
    } else if (scpService_.isOpen()) {
        words << tr("Nothing received yet");
    }
    if (received.problem) {
        words << ui::messageText(*received.problem);
    }
    return words.join(u'\n');
}

void ArchiveController::showPort()
{
    if (!dialog_) {
        if (const QString words = scpStatusText(); !words.isEmpty()) {
            emit reported(words);
        }
        return;
    }
    dialog_->receive().showListening(scpService_.isOpen());
    dialog_->receive().showReceived(scpStatusText(), scpService_.received().objects > 0);
}

}   // namespace angiopose::app
