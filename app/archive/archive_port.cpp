#include "app/archive/archive_port.h"

#include "app/archive/archive_words.h"
#include "app/archive/network_wait.h"
#include "io/archive/dimse/receiver.h"
#include "io/archive/store/cache.h"
#include "ui/words/message_text.h"

#include <utility>

namespace angiopose::app {
namespace {

using PortJob = Job<io::TransferReport, ArchivePort::Arrived>;

PortJob::Outcome receive(const ArchivePort::Wish& wish, PortJob::Link& link)
{
    const NetworkWait waiting;
    const auto store = io::ObjectStore::open(wish.folder, io::defaultObjectBytes);
    if (!store) {
        return store.error();
    }
    io::ReceiverOptions options;
    options.port = wish.port;
    options.ownTitle = wish.title;
    auto listening = io::Receiver::listen(options);
    if (!listening) {
        return listening.error();
    }
    io::Receiver receiver = std::move(listening).value();
    io::TransferReport report;
    const io::ArchiveObserver observe = [&link](const io::ArchiveProgress&) { return link.verdict(); };
    io::Arrivals arrivals(store.value(), {wish.mostBytes, io::StoreLimit::WhenFull::DropOldest}, report, observe);
    ArchivePort::Arrived arrived;
    arrivals.tell([&](const io::StoredObject& object) {
        ++arrived.objects;
        arrived.folders.insert(object.folder);
        link.tell(arrived);
    });
    receiver.serve(arrivals, [&link] { return link.verdict() == core::Verdict::Stop; });
    report.end = receiver.failure();
    return report;
}

}   // namespace

ArchivePort::ArchivePort(QObject* parent)
    : QObject(parent),
      job_({[this](const io::TransferReport& report) {
                const bool isFault = report.end && !report.end->isStop();
                emit closed(isFault ? ui::messageText(report.end->message) : QString());
            },
            [this](const core::Error& error) { emit closed(ui::messageText(error.message)); },
            [this](const Arrived& arrived) {
                arrived_ = arrived;
                emit changed();
            }})
{
}

void ArchivePort::open(const Wish& wish)
{
    arrived_ = {};
    port_ = wish.port;
    job_.start([wish](PortJob::Link& link) { return receive(wish, link); });
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

}   // namespace angiopose::app
