#include "app/archive/archive_port.h"

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

using PortJob = Job<io::TransferReport, ArchivePort::Arrived>;

/// Reports received objects to the window and records them in the audit file.
class PortNews {
public:
    PortNews(io::Arrivals& arrivals, const std::string& auditFile, PortJob::Link& link)
        : audit_(auditFile, {io::AuditEvent::Received, "angiopose", {}}), link_(link)
    {
        arrivals.tell([this](const io::StoredObject& object) {
            ++arrived_.objects;
            arrived_.folders.insert(object.folder);
            audit_.add(object.path);
            link_.tell(arrived_);
        });
        arrivals.tellProblems([this](const core::Message& problem) {
            arrived_.problem = problem;
            link_.tell(arrived_);
        });
    }

    void noteWhenDue()
    {
        audit_.noteWhenDue();
        tellUnaudited();
    }
    void noteAll()
    {
        audit_.noteAll();
        tellUnaudited();
    }

private:
    void tellUnaudited()
    {
        if (audit_.problem() && !arrived_.unaudited) {
            arrived_.unaudited = audit_.problem();
            link_.tell(arrived_);
        }
    }

    io::AuditBatch audit_;
    ArchivePort::Arrived arrived_;
    PortJob::Link& link_;
};

PortJob::Outcome receive(const ArchivePort::Request& request, const std::string& auditFile, PortJob::Link& link)
{
    const NetworkWait waiting;
    const auto store = io::ObjectStore::open(request.folder, io::defaultObjectBytes);
    if (!store) {
        return store.error();
    }
    auto listening = io::Receiver::listen(request.options);
    if (!listening) {
        return listening.error();
    }
    io::Receiver receiver = std::move(listening).value();
    io::TransferReport report;
    const io::ArchiveObserver observe = [&link](const io::ArchiveProgress&) { return link.verdict(); };
    io::Arrivals arrivals(store.value(), {request.maxBytes, io::StoreLimit::WhenFull::DropOldest}, report, observe);
    PortNews news(arrivals, auditFile, link);
    receiver.serve(arrivals, [&link, &news] {
        news.noteWhenDue();
        return link.verdict() == core::Verdict::Stop;
    });
    news.noteAll();
    report.end = receiver.failure();
    return report;
}

ui::PortEntry rememberedEntry()
{
    return {settings::receiveCallers.read(),     settings::receiveHosts.read(),       settings::receiveTls.read(),
            settings::receiveAuthorities.read(), settings::receiveCertificate.read(), settings::receiveKey.read()};
}

std::vector<std::string> listedIn(const QString& typed)
{
    std::vector<std::string> listed;
    for (const QString& each : typed.split(u',', Qt::SkipEmptyParts)) {
        if (const QString value = each.trimmed(); !value.isEmpty()) {
            listed.push_back(value.toStdString());
        }
    }
    return listed;
}

io::ReceiverOptions optionsOf(const ui::PortEntry& entry)
{
    io::ReceiverOptions options;
    options.titles = listedIn(entry.titles);
    options.hosts = listedIn(entry.hosts);
    options.isTls = entry.isTls;
    options.tls = {entry.caFile.toStdString(), entry.certificateFile.toStdString(), entry.keyFile.toStdString()};
    return options;
}

}   // namespace

ArchivePort::ArchivePort(QObject* parent)
    : QObject(parent),
      job_({[this](const io::TransferReport& report) {
                const bool isFault = report.end && !report.end->isStop();
                emit closed(isFault ? ui::messageText(report.end->message) : QString());
            },
            [this](const core::Error& error) { emit closed(ui::messageText(error.message)); },
            [this](const Arrived& arrived) { take(arrived); }})
{
}

void ArchivePort::open(const Request& request)
{
    arrived_ = {};
    port_ = request.options.port;
    job_.start(
        [request, audit = auditPath().toStdString()](PortJob::Link& link) { return receive(request, audit, link); });
}

void ArchivePort::take(const Arrived& arrived)
{
    const bool isNew = arrived.unaudited && !arrived_.unaudited;
    arrived_ = arrived;
    emit changed();
    if (isNew) {
        emit unaudited(ui::messageText(*arrived.unaudited));
    }
}

void ArchivePort::close()
{
    job_.requestStop();
}

QStringList ArchivePort::folders() const
{
    QStringList folders;
    for (const std::string& folder : arrived_.folders) {
        folders << QString::fromStdString(folder);
    }
    return folders;
}

io::ReceiverOptions receiverOptions(int port, const QString& title)
{
    io::ReceiverOptions options = optionsOf(rememberedEntry());
    options.port = port;
    options.ownTitle = title.toStdString();
    return options;
}

PortSecurity::PortSecurity(QWidget& dialogParent, QObject* parent) : QObject(parent), dialogParent_(dialogParent) {}

void PortSecurity::ask()
{
    dialog_ = new ui::PortDialog(rememberedEntry(), &dialogParent_);
    connect(dialog_, &ui::PortDialog::saveRequested, this, &PortSecurity::save);
    dialog_->open();
}

void PortSecurity::save(const ui::PortEntry& entry)
{
    if (const auto checked = io::checkReceiver(optionsOf(entry)); !checked) {
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
