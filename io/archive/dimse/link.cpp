#include "io/archive/dimse/link.h"

#include "io/archive/dimse/association_failure.h"
#include "io/messages/messages.h"

#include <utility>

namespace angiopose::io {
namespace {

constexpr std::size_t maxAnswerBytes = std::size_t{4} << 20;
constexpr std::size_t maxCommandBytes = std::size_t{64} << 10;

core::Error nonsense(const Association& association)
{
    return core::Error(messages::archiveNonsense("DIMSE").about(association.node().name));
}

}   // namespace

DimseLink::DimseLink(std::unique_ptr<Association> association) : association_(std::move(association)) {}

core::Result<DimseLink> DimseLink::open(const ArchiveNode& node, const std::vector<ProposedContext>& contexts,
                                        StopQuestion isStopRequested)
{
    if (auto checked = checkNode(node); !checked) {
        return checked.error();
    }
    if (node.host.empty()) {
        return core::Error(messages::archiveNoDimse().about(node.name));
    }
    auto association = Association::request(node, contexts, std::move(isStopRequested));
    if (!association) {
        return association.error();
    }
    return DimseLink(std::move(association).value());
}

DimseLink DimseLink::accepted(T_ASC_Association* association, const ArchiveNode& peer, StopQuestion isStopRequested)
{
    return DimseLink(std::make_unique<Association>(association, peer, std::move(isStopRequested)));
}

std::optional<AcceptedContext> DimseLink::contextFor(const std::string& abstractSyntax,
                                                     const std::string& transferSyntax) const
{
    for (const AcceptedContext& context : association_->contexts()) {
        if (context.abstractSyntax == abstractSyntax &&
            (transferSyntax.empty() || context.transferSyntax == transferSyntax)) {
            return context;
        }
    }
    return std::nullopt;
}

std::optional<AcceptedContext> DimseLink::contextOf(std::uint8_t id) const
{
    for (const AcceptedContext& context : association_->contexts()) {
        if (context.id == id) {
            return context;
        }
    }
    return std::nullopt;
}

core::Status DimseLink::send(std::uint8_t context, const DimseCommand& command)
{
    return association_->write({DataValue::Kind::Command, context, command.encoded(), true});
}

core::Status DimseLink::sendPieces(std::uint8_t context, const PieceSource& next)
{
    for (bool isLast = false; !isLast;) {
        if (association_->isStopRequested()) {
            return stoppedAssociation(association_->node());
        }
        auto piece = next(association_->maxPieceBytes());
        if (!piece) {
            return piece.error();
        }
        isLast = piece.value().isLast;
        if (auto sent = association_->write({DataValue::Kind::DataSet, context, piece.value().bytes, isLast}); !sent) {
            return sent;
        }
    }
    return core::Done{};
}

core::Status DimseLink::sendData(std::uint8_t context, std::string_view data)
{
    return sendPieces(context, [&data](std::size_t maxBytes) -> core::Result<Piece> {
        Piece piece{data.substr(0, maxBytes), data.size() <= maxBytes};
        data.remove_prefix(piece.bytes.size());
        return piece;
    });
}

core::Result<std::optional<DimseLink::Received>> DimseLink::receive(const LifeQuestion& isAlive)
{
    std::string bytes;
    for (;;) {
        auto read = association_->read(isAlive);
        if (!read) {
            return read.error();
        }
        if (!read.value()) {
            return std::optional<Received>();
        }
        const DataValue& value = *read.value();
        if (value.kind != DataValue::Kind::Command || bytes.size() + value.bytes.size() > maxCommandBytes) {
            return nonsense(*association_);
        }
        bytes += value.bytes;
        if (value.isLast) {
            const auto command = DimseCommand::decode(bytes);
            return command ? core::Result<std::optional<Received>>(Received{*command, value.context})
                           : nonsense(*association_);
        }
    }
}

core::Status DimseLink::receivePieces(const PieceSink& take)
{
    for (;;) {
        auto read = association_->read();
        if (!read) {
            return read.error();
        }
        if (!read.value() || read.value()->kind != DataValue::Kind::DataSet) {
            return nonsense(*association_);
        }
        const DataValue& value = *read.value();
        if (association_->isStopRequested()) {
            return stoppedAssociation(association_->node());
        }
        if (auto taken = take(value.bytes); !taken) {
            return taken;
        }
        if (value.isLast) {
            return core::Done{};
        }
    }
}

core::Result<std::string> DimseLink::receiveData()
{
    std::string data;
    auto received = receivePieces([this, &data](std::string_view piece) -> core::Status {
        if (data.size() + piece.size() > maxAnswerBytes) {
            return nonsense(*association_);
        }
        data += piece;
        return core::Done{};
    });
    return received ? core::Result<std::string>(std::move(data)) : core::Result<std::string>(received.error());
}

void DimseLink::release()
{
    association_->release();
}

}   // namespace angiopose::io
