#include "io/archive/dimse/get_series.h"

#include "io/archive/dimse/identifier.h"
#include "io/archive/dimse/receive_object.h"
#include "io/archive/dimse/storage_classes.h"
#include "io/archive/dimse/storage_scp.h"
#include "io/messages/messages.h"

#include <atomic>
#include <thread>

namespace angiopose::io {
namespace {

std::string seriesIdentifier(const SeriesRequest& series)
{
    return encodeIdentifier({{0x00080052, "SERIES"}, {0x0020000d, series.studyUid}, {0x0020000e, series.seriesUid}});
}

/// Fails unless the final response reports full or partial success; the caller reports missing objects separately.
core::Status checkFinalResponse(const ArchiveNode& node, const std::string& service, const DimseCommand& answer)
{
    const std::uint16_t status = answer.status();
    if (status == dimse::success || status == dimse::suboperationsFailed) {
        return core::Done{};
    }
    return core::Error(messages::archiveStatus(service, statusText(answer)).about(node.name));
}

bool isPending(const DimseCommand& answer)
{
    return answer.status() == dimse::pending;
}

/// Receives objects and pending responses until the final response arrives.
core::Status receiveAll(DimseLink& link, const ArchiveNode& node, const SeriesRequest& series, StoreWriter& storeWriter)
{
    const ExpectedObject expected{series.studyUid, series.seriesUid, {}};
    for (;;) {
        auto received = link.receive();
        if (!received) {
            return received.error();
        }
        if (!received.value()) {
            return core::Error(messages::archiveAborted().about(node.name));
        }
        const DimseLink::ReceivedCommand& message = *received.value();
        if (message.command.kind() == DimseMessageType::StoreRequest) {
            if (auto taken = receiveObject(link, message, expected, storeWriter); !taken) {
                return taken;
            }
            continue;
        }
        if (message.command.kind() != DimseMessageType::GetResponse) {
            return core::Error(messages::archiveNonsense("C-GET").about(node.name));
        }
        if (message.command.hasData()) {
            if (auto ignored = link.receiveData(); !ignored) {
                return ignored.error();
            }
        }
        if (!isPending(message.command)) {
            return checkFinalResponse(node, "C-GET", message.command);
        }
    }
}

/// Runs the storage SCP on the receiving port in its own thread while another association requests C-MOVE.
class ReceivingThread {
public:
    ReceivingThread(StorageScp& receiver, StoreWriter& storeWriter)
        : thread_([this, &receiver, &storeWriter] { receiver.serve(storeWriter, [this] { return isOver_.load(); }); })
    {
    }
    ReceivingThread(const ReceivingThread&) = delete;
    ReceivingThread& operator=(const ReceivingThread&) = delete;
    ~ReceivingThread() { finish(); }

    void finish()
    {
        isOver_ = true;
        if (thread_.joinable()) {
            thread_.join();
        }
    }

private:
    std::atomic<bool> isOver_{false};
    std::thread thread_;
};

/// Waits for the final response; objects arriving meanwhile show that the archive is still active.
core::Status awaitEnd(DimseLink& link, const ArchiveNode& node, StoreWriter& storeWriter)
{
    std::uint64_t seen = storeWriter.receivedBytes();
    const ActivityCheck hasActivity = [&seen, &storeWriter] {
        return std::exchange(seen, storeWriter.receivedBytes()) != seen;
    };
    for (;;) {
        auto received = link.receive(hasActivity);
        if (!received) {
            return received.error();
        }
        if (!received.value() || received.value()->command.kind() != DimseMessageType::MoveResponse) {
            return core::Error(messages::archiveNonsense("C-MOVE").about(node.name));
        }
        const DimseCommand& answer = received.value()->command;
        if (answer.hasData()) {
            if (auto ignored = link.receiveData(); !ignored) {
                return ignored.error();
            }
        }
        if (!isPending(answer)) {
            return checkFinalResponse(node, "C-MOVE", answer);
        }
    }
}

}   // namespace

core::Result<std::optional<core::Done>> getSeries(const ArchiveNode& node, const SeriesRequest& series,
                                                  StoreWriter& storeWriter)
{
    auto contexts = storageContexts(series.objects, 1);
    contexts.push_back({sop::get, {implicitLittleEndian}});
    auto opened = DimseLink::open(node, contexts, [&storeWriter] { return storeWriter.isStopRequested(); });
    if (!opened) {
        return opened.error();
    }
    DimseLink link = std::move(opened).value();
    const auto context = link.contextFor(sop::get);
    if (!context) {
        link.release();
        return std::optional<core::Done>();
    }
    DimseCommand request(DimseMessageType::GetRequest, 1, sop::get);
    request.setNumber(DimseCommand::priority, 0);
    request.setHasData();
    if (auto sent = link.send(context->id, request); !sent) {
        return sent.error();
    }
    if (auto sent = link.sendData(context->id, seriesIdentifier(series)); !sent) {
        return sent.error();
    }
    if (auto taken = receiveAll(link, node, series, storeWriter); !taken) {
        return taken.error();
    }
    link.release();
    return std::optional(core::Done{});
}

core::Status moveSeries(const ArchiveNode& node, const SeriesRequest& series, StoreWriter& storeWriter)
{
    if (node.receivePort == 0) {
        return core::Error(messages::archiveNoWayBack().about(node.name));
    }
    StorageScpOptions options;
    options.port = node.receivePort;
    options.ownAeTitle = node.ownAeTitle;
    options.expected = {series.studyUid, series.seriesUid, {}};
    options.isTls = node.isTls && !node.certificateFile.empty();
    options.tls = {node.caFile, node.certificateFile, node.keyFile};
    auto listening = StorageScp::listen(options);
    if (!listening) {
        return listening.error();
    }
    StorageScp receiver = std::move(listening).value();
    auto opened = DimseLink::open(node, {{sop::move, {implicitLittleEndian}}},
                                  [&storeWriter] { return storeWriter.isStopRequested(); });
    if (!opened) {
        return opened.error();
    }
    DimseLink link = std::move(opened).value();
    const auto context = link.contextFor(sop::move);
    if (!context) {
        return core::Error(messages::archiveNoService("C-GET, C-MOVE", node.ownAeTitle).about(node.name));
    }
    DimseCommand request(DimseMessageType::MoveRequest, 1, sop::move);
    request.setText(DimseCommand::moveDestination, node.ownAeTitle, ' ');
    request.setNumber(DimseCommand::priority, 0);
    request.setHasData();
    ReceivingThread thread(receiver, storeWriter);
    if (auto sent = link.send(context->id, request); !sent) {
        return sent;
    }
    if (auto sent = link.sendData(context->id, seriesIdentifier(series)); !sent) {
        return sent;
    }
    auto ended = awaitEnd(link, node, storeWriter);
    thread.finish();
    if (ended) {
        link.release();
    }
    return receiver.failure() ? core::Status(*receiver.failure()) : ended;
}

}   // namespace angiopose::io
