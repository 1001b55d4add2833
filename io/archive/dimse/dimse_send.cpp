#include "io/archive/dimse/dimse_send.h"

#include "io/archive/dimse/find.h"
#include "io/archive/dimse/get_series.h"
#include "io/archive/dimse/link.h"
#include "io/archive/dimse/storage_classes.h"
#include "io/messages/messages.h"

#include <fstream>
#include <set>
#include <span>
#include <utility>

namespace angiopose::io {
namespace {

using Encoding = std::pair<std::string, std::string>;   ///< SOP class and transfer syntax

/// Returns the first files whose encodings fit into the presentation contexts of one association.
std::span<const SendableFile> nextBatch(std::span<const SendableFile> files, std::set<Encoding>& encodings)
{
    std::size_t count = 0;
    for (const SendableFile& file : files) {
        const Encoding encoding(file.sopClass, file.transferSyntax);
        if (!encodings.contains(encoding) && encodings.size() == maxContexts) {
            break;
        }
        encodings.insert(encoding);
        ++count;
    }
    return files.first(count);
}

class Sending {
public:
    Sending(const ArchiveNode& node, const ArchiveObserver& observe, TransferReport& report)
        : node_(node), observe_(observe), report_(report)
    {
    }

    bool isStopRequested() const
    {
        const std::size_t done = report_.transferred + report_.duplicates + report_.failed;
        return observe_ && observe_({done, report_.all, bytes_}) == core::ObserverDecision::Stop;
    }

    core::Status sendBatch(std::span<const SendableFile> files, const std::set<Encoding>& encodings)
    {
        std::vector<ProposedContext> contexts;
        for (const auto& [sopClass, syntax] : encodings) {
            contexts.push_back({sopClass, {syntax}});
        }
        auto opened = DimseLink::open(node_, contexts, [this] { return isStopRequested(); });
        if (!opened) {
            return opened.error();
        }
        DimseLink link = std::move(opened).value();
        for (const SendableFile& file : files) {
            if (auto sent = sendFile(link, file); !sent) {
                return sent;
            }
        }
        link.release();
        return core::Done{};
    }

private:
    void fail(const SendableFile& file, const core::Message& why)
    {
        ++report_.failed;
        report_.addProblem(why.about(file.path));
    }

    core::Status sendFile(DimseLink& link, const SendableFile& file)
    {
        const auto context = link.contextFor(file.sopClass, file.transferSyntax);
        if (!context) {
            fail(file, messages::archiveNotTaken(file.sopClass, file.transferSyntax));
            return core::Done{};
        }
        DimseCommand request(DimseMessageType::StoreRequest, ++messageId_, file.sopClass);
        request.setNumber(DimseCommand::priority, 0);
        request.setText(DimseCommand::affectedSopInstance, file.sopInstance);
        request.setHasData();
        if (auto sent = link.send(context->id, request); !sent) {
            return sent;
        }
        if (auto sent = sendDataset(link, context->id, file); !sent) {
            return sent;
        }
        return settle(link, file);
    }

    core::Status sendDataset(DimseLink& link, std::uint8_t context, const SendableFile& file)
    {
        std::ifstream stream(file.path, std::ios::binary);
        stream.seekg(static_cast<std::streamoff>(file.dataset));
        std::uint64_t left = file.bytes - file.dataset;
        std::string block;
        return link.sendFragments(context, [&](std::size_t maxBytes) -> core::Result<DimseLink::Fragment> {
            block.resize(static_cast<std::size_t>(std::min<std::uint64_t>(left, maxBytes & ~std::size_t{1})));
            if (!stream.read(block.data(), static_cast<std::streamsize>(block.size()))) {
                return core::Error(messages::archiveNotSendable().about(file.path));
            }
            left -= block.size();
            bytes_ += block.size();
            return DimseLink::Fragment{block, left == 0};
        });
    }

    core::Status settle(DimseLink& link, const SendableFile& file)
    {
        auto received = link.receive();
        if (!received) {
            return received.error();
        }
        if (!received.value() || received.value()->command.kind() != DimseMessageType::StoreResponse) {
            return core::Error(messages::archiveNonsense("C-STORE").about(node_.name));
        }
        const DimseCommand& answer = received.value()->command;
        const bool isWarning = (answer.status() & 0xf000U) == 0xb000U;   // stored, but elements were coerced
        if (answer.status() == dimse::duplicateInstance) {
            ++report_.duplicates;
        } else if (answer.status() == dimse::success || isWarning) {
            ++report_.transferred;
            report_.bytes += file.bytes;
        } else {
            fail(file, messages::archiveStoreRefused(statusText(answer)));
        }
        return core::Done{};
    }

    const ArchiveNode& node_;
    const ArchiveObserver& observe_;
    TransferReport& report_;
    std::uint64_t bytes_ = 0;
    std::uint16_t messageId_ = 0;
};

class DimseSource : public SeriesSource {
public:
    DimseSource(ArchiveNode node, StopCheck isStopRequested)
        : node_(std::move(node)), isStopRequested_(std::move(isStopRequested))
    {
    }

    core::Result<std::vector<std::string>> seriesOf(const std::string& studyUid) override
    {
        auto opened = openFindAssociation(node_, isStopRequested_);
        if (!opened) {
            return opened.error();
        }
        DimseLink link = std::move(opened).value();
        auto found = findSeries(link, node_, studyUid);
        return released(std::move(link), std::move(found));
    }

    core::Result<std::vector<ArchiveObject>> objectsOf(const std::string& studyUid,
                                                       const std::string& seriesUid) override
    {
        auto opened = openFindAssociation(node_, isStopRequested_);
        if (!opened) {
            return opened.error();
        }
        DimseLink link = std::move(opened).value();
        auto found = findObjects(link, node_, studyUid, seriesUid);
        return released(std::move(link), std::move(found));
    }

    core::Status fetch(const std::string& studyUid, const std::string& seriesUid,
                       const std::vector<ArchiveObject>& objects, StoreWriter& storeWriter) override
    {
        const SeriesRequest series{studyUid, seriesUid, objects};
        auto got = getSeries(node_, series, storeWriter);
        if (!got) {
            return got.error();
        }
        return got.value() ? core::Status(core::Done{}) : moveSeries(node_, series, storeWriter);
    }

private:
    template <class Found>
    static Found released(DimseLink link, Found found)
    {
        if (found) {
            link.release();
        }
        return found;
    }

    ArchiveNode node_;
    StopCheck isStopRequested_;
};

}   // namespace

void dimseSend(const ArchiveNode& node, const std::vector<SendableFile>& files, const ArchiveObserver& observe,
               TransferReport& report)
{
    Sending sending(node, observe, report);
    for (std::span<const SendableFile> left(files); !left.empty();) {
        std::set<Encoding> encodings;
        const auto batch = nextBatch(left, encodings);
        if (auto sent = sending.sendBatch(batch, encodings); !sent) {
            report.end = sent.error();
            return;
        }
        left = left.subspan(batch.size());
    }
}

std::unique_ptr<SeriesSource> makeDimseSource(const ArchiveNode& node, const StopCheck& isStopRequested)
{
    return std::make_unique<DimseSource>(node, isStopRequested);
}

}   // namespace angiopose::io
