#include "app/archive/storage_scp_service.h"

#include "app/archive/archive_settings.h"
#include "app/archive/archive_words.h"
#include "app/archive/network_wait.h"
#include "app/preferences/save_folder.h"
#include "io/archive/store/cache.h"
#include "io/sharing/audit_file.h"
#include "ui/archive/port_dialog.h"
#include "ui/archive/transfer_line.h"
#include "ui/words/message_text.h"

#include <utility>

namespace angiopose::app {
namespace {

using PortJob = Job<io::TransferReport, StorageScpService::ReceivedObjects>;

/// Reports received objects to the window and records them in the audit file.
class ReceiveReporter {
public:
    ReceiveReporter(io::StoreWriter& storeWriter, const std::string& auditFile, PortJob::Link& link)
        : audit_(auditFile, {io::AuditEvent::Received, "angiopose", {}}), link_(link)
    {
        storeWriter.tell([this](const io::StoredObject& object) {
            ++received_.objects;
            received_.folders.insert(object.folder);
            audit_.add(object.path);
            link_.tell(received_);
        });
        storeWriter.setProblemCallback([this](const core::Message& problem) {
            received_.problem = problem;
            link_.tell(received_);
        });
    }

    void flushIfDue()
    {
        audit_.flushIfDue();
        reportUnaudited();
    }
    void flush()
    {
        audit_.flush();
        reportUnaudited();
    }

private:
    void reportUnaudited()
    {
        if (audit_.problem() && !received_.auditFailed) {
            received_.auditFailed = audit_.problem();
            link_.tell(received_);
        }
    }

    io::AuditBatch audit_;
    StorageScpService::ReceivedObjects received_;
    PortJob::Link& link_;
};

PortJob::Outcome receive(const StorageScpService::Request& request, const std::string& auditFile, PortJob::Link& link)
{
    const ThreadPoolRelease waiting;
    const auto store = io::ObjectStore::open(request.folder, io::defaultMaxObjectBytes);
    if (!store) {
        return store.error();
    }
    auto listening = io::StorageScp::listen(request.options);
    if (!listening) {
        return listening.error();
    }
    io::StorageScp receiver = std::move(listening).value();
    io::TransferReport report;
    const io::ArchiveObserver observe = [&link](const io::ArchiveProgress&) { return link.decision(); };
    io::StoreWriter storeWriter(store.value(), {request.maxBytes, io::StoreLimit::FullStorePolicy::DeleteOldest},
                                report, observe);
    ReceiveReporter news(storeWriter, auditFile, link);
    receiver.serve(storeWriter, [&link, &news] {
        news.flushIfDue();
        return link.decision() == core::ObserverDecision::Stop;
    });
    news.flush();
    report.end = receiver.failure();
    return report;
}

ui::ScpSettings rememberedEntry()
{
    return {settings::receiveCallers.read(),     settings::receiveHosts.read(),       settings::receiveTls.read(),
            settings::receiveAuthorities.read(), settings::receiveCertificate.read(), settings::receiveKey.read()};
}

std::vector<std::string> listedIn(const QString& typed)
{
    std::vector<std::string> listed;
    for (const QString& item : typed.split(u',', Qt::SkipEmptyParts)) {
        if (const QString value = item.trimmed(); !value.isEmpty()) {
            listed.push_back(value.toStdString());
        }
    }
    return listed;
}

io::StorageScpOptions optionsOf(const ui::ScpSettings& entry)
{
    io::StorageScpOptions options;
    options.titles = listedIn(entry.titles);
    options.hosts = listedIn(entry.hosts);
    options.isTls = entry.isTls;
    options.tls = {entry.caFile.toStdString(), entry.certificateFile.toStdString(), entry.keyFile.toStdString()};
    return options;
}

}   // namespace

StorageScpService::StorageScpService(QObject* parent)
    : QObject(parent),
      job_({[this](const io::TransferReport& report) {
                const bool isFault = report.end && !report.end->isCancellation();
                emit closed(isFault ? ui::messageText(report.end->message) : QString());
            },
            [this](const core::Error& error) { emit closed(ui::messageText(error.message)); },
            [this](const ReceivedObjects& received) { addReceived(received); }})
{
}

void StorageScpService::open(const Request& request)
{
    received_ = {};
    port_ = request.options.port;
    job_.start(
        [request, audit = auditPath().toStdString()](PortJob::Link& link) { return receive(request, audit, link); });
}

void StorageScpService::addReceived(const ReceivedObjects& received)
{
    const bool isNew = received.auditFailed && !received_.auditFailed;
    received_ = received;
    emit changed();
    if (isNew) {
        emit auditFailed(ui::messageText(*received.auditFailed));
    }
}

void StorageScpService::close()
{
    job_.requestStop();
}

QStringList StorageScpService::folders() const
{
    QStringList folders;
    for (const std::string& folder : received_.folders) {
        folders << QString::fromStdString(folder);
    }
    return folders;
}

io::StorageScpOptions receiverOptions(int port, const QString& title)
{
    io::StorageScpOptions options = optionsOf(rememberedEntry());
    options.port = port;
    options.ownAeTitle = title.toStdString();
    return options;
}

StorageScpSecurity::StorageScpSecurity(QWidget& dialogParent, QObject* parent)
    : QObject(parent), dialogParent_(dialogParent)
{
}

void StorageScpSecurity::openDialog()
{
    dialog_ = new ui::PortDialog(rememberedEntry(), &dialogParent_);
    connect(dialog_, &ui::PortDialog::saveRequested, this, &StorageScpSecurity::save);
    dialog_->open();
}

void StorageScpSecurity::save(const ui::ScpSettings& entry)
{
    if (const auto checked = io::checkStorageScpOptions(optionsOf(entry)); !checked) {
        dialog_->line().showProblem(ui::messageText(checked.error().message));
        return;
    }
    settings::receiveCallers.write(entry.titles);
    settings::receiveHosts.write(entry.hosts);
    settings::receiveTls.write(entry.isTls);
    settings::receiveAuthorities.write(entry.caFile);
    settings::receiveCertificate.write(entry.certificateFile);
    settings::receiveKey.write(entry.keyFile);
    dialog_->accept();
}

}   // namespace angiopose::app
