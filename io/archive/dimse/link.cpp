#include "io/archive/dimse/link.h"

#include "io/archive/dimse/association_failure.h"
#include "io/messages/messages.h"

#include <utility>

namespace angiopose::io {
namespace {

constexpr std::size_t maxAnswerBytes = std::size_t{4} << 20;
constexpr std::size_t maxCommandBytes = std::size_t{64} << 10;

core::Error unexpectedMessage(const Association& association)
{
    return core::Error(messages::archiveNonsense("DIMSE").about(association.node().name));
}

}   // namespace

DimseLink::DimseLink(std::unique_ptr<Association> association) : association_(std::move(association)) {}

core::Result<DimseLink> DimseLink::open(const ArchiveNode& node, const std::vector<ProposedContext>& contexts,
                                        StopCheck isStopRequested)
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

DimseLink DimseLink::accepted(T_ASC_Association* association, const ArchiveNode& peer, StopCheck isStopRequested)
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

std::optional<AcceptedContext> DimseLink::contextWithId(std::uint8_t id) const
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
    return association_->write({PresentationDataValue::Kind::Command, context, command.encoded(), true});
}

core::Status DimseLink::sendFragments(std::uint8_t context, const FragmentSource& next)
{
    for (bool isLast = false; !isLast;) {
        if (association_->isStopRequested()) {
            return canceledAssociationError(association_->node());
        }
        auto piece = next(association_->maxFragmentBytes());
        if (!piece) {
            return piece.error();
        }
        isLast = piece.value().isLast;
        if (auto sent =
                association_->write({PresentationDataValue::Kind::DataSet, context, piece.value().bytes, isLast});
            !sent) {
            return sent;
        }
    }
    return core::Done{};
}

core::Status DimseLink::sendData(std::uint8_t context, std::string_view data)
{
    return sendFragments(context, [&data](std::size_t maxBytes) -> core::Result<Fragment> {
        Fragment piece{data.substr(0, maxBytes), data.size() <= maxBytes};
        data.remove_prefix(piece.bytes.size());
        return piece;
    });
}

core::Result<std::optional<DimseLink::ReceivedCommand>> DimseLink::receive(const ActivityCheck& hasActivity)
{
    std::string bytes;
    for (;;) {
        auto read = association_->read(hasActivity);
        if (!read) {
            return read.error();
        }
        if (!read.value()) {
            return std::optional<ReceivedCommand>();
        }
        const PresentationDataValue& value = *read.value();
        if (value.kind != PresentationDataValue::Kind::Command || bytes.size() + value.bytes.size() > maxCommandBytes) {
            return unexpectedMessage(*association_);
        }
        bytes += value.bytes;
        if (value.isLast) {
            const auto command = DimseCommand::decode(bytes);
            return command ? core::Result<std::optional<ReceivedCommand>>(ReceivedCommand{*command, value.context})
                           : unexpectedMessage(*association_);
        }
    }
}

core::Status DimseLink::receiveFragments(const FragmentSink& take)
{
    for (;;) {
        auto read = association_->read();
        if (!read) {
            return read.error();
        }
        if (!read.value() || read.value()->kind != PresentationDataValue::Kind::DataSet) {
            return unexpectedMessage(*association_);
        }
        const PresentationDataValue& value = *read.value();
        if (association_->isStopRequested()) {
            return canceledAssociationError(association_->node());
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
    auto received = receiveFragments([this, &data](std::string_view piece) -> core::Status {
        if (data.size() + piece.size() > maxAnswerBytes) {
            return unexpectedMessage(*association_);
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
