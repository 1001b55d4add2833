#include "app/archive/archive_controller.h"

#include "app/archive/archive_cache.h"
#include "app/archive/archive_habits.h"
#include "app/archive/archive_nodes.h"
#include "app/archive/archive_retrieval.h"
#include "ui/archive/archive_dialog.h"
#include "ui/archive/node_bar.h"
#include "ui/archive/receive_line.h"
#include "ui/archive/search_fields.h"
#include "ui/archive/transfer_line.h"

#include <QAction>

namespace angiopose::app {

ArchiveController::ArchiveController(const Ui& ui, QObject* parent) : QObject(parent), ui_(ui)
{
    connect(&port_, &ArchivePort::changed, this, &ArchiveController::showPort);
    connect(&port_, &ArchivePort::closed, this, [this](const QString& problem) {
        showPort();
        if (dialog_ && !problem.isEmpty()) {
            dialog_->line().showProblem(problem);
        } else if (!problem.isEmpty()) {
            emit told(problem);
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
    connectPort();
    list_.read();
    dialog_->open();
    dialog_->fields().focusFirst();
}

void ArchiveController::connectParts()
{
    ui::ArchiveDialog& dialog = *dialog_;
    nodes_ = new ArchiveNodes(list_, {dialog.nodes(), dialog.line(), dialog}, dialog_);
    finder_ = new ArchiveFinder(dialog, findings_, ui_.hideIdentity, dialog_);
    retrieval_ = new ArchiveRetrieval(dialog, dialog_);
    auto* cache = new ArchiveCache(list_, {dialog.cache(), dialog.line(), dialog}, dialog_);
    connect(nodes_, &ArchiveNodes::chosen, finder_, [this] { finder_->follow(nodes_->node()); });
    connect(dialog_, &ui::ArchiveDialog::retrieveRequested, this, &ArchiveController::retrieve);
    connect(retrieval_, &ArchiveRetrieval::ended, cache, &ArchiveCache::measure);
    const auto offerRetrieved = [this] { offer(retrieval_->folders(), dialog_->nodes().node()); };
    connect(retrieval_, &ArchiveRetrieval::retrieved, this, offerRetrieved);
    connect(retrieval_, &ArchiveRetrieval::unaudited, this, &ArchiveController::unaudited);
    connect(dialog_, &ui::ArchiveDialog::partRequested, this, offerRetrieved);
}

void ArchiveController::connectPort()
{
    ui::ReceiveLine& line = dialog_->receive();
    line.showPort(settings::receivePort.read(), settings::receiveTitle.read());
    showPort();
    connect(&line, &ui::ReceiveLine::switched, this, &ArchiveController::switchPort);
    connect(&line, &ui::ReceiveLine::openRequested, this,
            [this] { offer(port_.folders(), tr("what arrived on port %1").arg(port_.port())); });
}

void ArchiveController::retrieve()
{
    const auto node = nodes_->node();
    const auto wishes = finder_->wishes();
    if (node && !wishes.empty()) {
        retrieval_->start(*node, list_.settings(), wishes);
    }
}

/// One dialog goes, then the next one comes.
void ArchiveController::offer(const QStringList& folders, const QString& name)
{
    dialog_->accept();
    QMetaObject::invokeMethod(
        this, [this, folders, name] { emit retrieved(folders, name); }, Qt::QueuedConnection);
}

void ArchiveController::switchPort(bool isOn)
{
    if (!isOn) {
        port_.close();
        return;
    }
    const ui::ReceiveLine& line = dialog_->receive();
    settings::receivePort.write(line.port());
    settings::receiveTitle.write(line.title());
    port_.open({line.port(), line.title().toStdString(), list_.settings().cache(), list_.settings().cacheBytes});
    showPort();
}

void ArchiveController::showPort()
{
    const std::size_t objects = port_.arrived().objects;
    if (!dialog_) {
        emit told(tr("Objects that arrived: %1").arg(objects));
        return;
    }
    dialog_->receive().showListening(port_.isOpen());
    const QString words = objects > 0      ? tr("Objects that arrived: %1").arg(objects)
                          : port_.isOpen() ? tr("Nothing arrived yet")
                                           : QString();
    dialog_->receive().showArrivals(words, objects > 0);
}

}   // namespace angiopose::app
