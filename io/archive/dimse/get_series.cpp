#include "io/archive/dimse/get_series.h"

#include "io/archive/dimse/retrieve_request.h"
#include "io/archive/dimse/storage_classes.h"
#include "io/archive/dimse/take_object.h"

namespace angiopose::io {
namespace {

/// Objects and answers in turn, until the last answer.
core::Status takeAll(DimseLink& link, const ArchiveNode& node, const SeriesWish& wish, Arrivals& arrivals)
{
    const ExpectedObject expected{wish.studyUid, wish.seriesUid, {}};
    for (;;) {
        auto received = link.receive();
        if (!received) {
            return received.error();
        }
        if (!received.value()) {
            return core::Error(says::archiveAborted().about(node.name));
        }
        const DimseLink::Received& message = *received.value();
        if (message.command.kind() == DimseKind::StoreRequest) {
            if (auto taken = takeObject(link, message, expected, arrivals); !taken) {
                return taken;
            }
            continue;
        }
        if (message.command.kind() != DimseKind::GetResponse) {
            return core::Error(says::archiveNonsense("C-GET").about(node.name));
        }
        if (message.command.hasData()) {
            if (auto ignored = link.receiveData(); !ignored) {
                return ignored.error();
            }
        }
        if (!isPending(message.command)) {
            return settleRetrieval(node, "C-GET", message.command);
        }
    }
}

}   // namespace

core::Result<std::optional<core::Done>> getSeries(const ArchiveNode& node, const SeriesWish& wish, Arrivals& arrivals)
{
    auto contexts = receivingContexts(wish.objects, 1);
    contexts.push_back({sop::get, {implicitLittleEndian}});
    auto opened = DimseLink::open(node, contexts, [&arrivals] { return arrivals.isStopWished(); });
    if (!opened) {
        return opened.error();
    }
    DimseLink link = std::move(opened).value();
    const auto context = link.contextFor(sop::get);
    if (!context) {
        link.release();
        return std::optional<core::Done>();
    }
    DimseCommand request(DimseKind::GetRequest, 1, sop::get);
    request.setNumber(DimseCommand::priority, 0);
    request.setHasData();
    if (auto sent = link.send(context->id, request); !sent) {
        return sent.error();
    }
    if (auto sent = link.sendData(context->id, seriesIdentifier(wish)); !sent) {
        return sent.error();
    }
    if (auto taken = takeAll(link, node, wish, arrivals); !taken) {
        return taken.error();
    }
    link.release();
    return std::optional(core::Done{});
}

}   // namespace angiopose::io
