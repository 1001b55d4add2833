#include "io/archive/dimse/link.h"

#include "io/archive/dimse/association_failure.h"
#include "io/archive/dimse/tls.h"
#include "io/messages/says_archive.h"
#include "io/support/quiet_libraries.h"

#include <dcmtk/config/osconfig.h>
// DCMTK's macros first.
#include <dcmtk/dcmnet/assoc.h>
#include <dcmtk/dcmnet/dcmtrans.h>
#include <dcmtk/dcmnet/dul.h>
#include <dcmtk/ofstd/ofsockad.h>
#include <dcmtk/ofstd/ofstd.h>
#include <atomic>
#include <chrono>
#include <future>
#include <thread>
#include <utility>

namespace angiopose::io {
namespace {

constexpr std::size_t mostAnswerBytes = std::size_t{4} << 20;
constexpr std::size_t mostCommandBytes = std::size_t{64} << 10;
constexpr long pduBytes = ASC_MAXIMUMPDUSIZE;

core::Error stoppedLink(const ArchiveNode& node)
{
    return core::Error(core::Stopped{says::archiveStopped()}).about(node.name);
}

/// A resolver without network may take half a minute: it is left behind.
core::Status resolveHost(const ArchiveNode& node, const StopQuestion& isStopWished)
{
    auto promise = std::make_shared<std::promise<bool>>();
    auto isKnown = promise->get_future();
    std::thread([promise, host = node.host] {
        OFSockAddr address;
        OFStandard::getAddressByHostname(host.c_str(), address);
        promise->set_value(address.size() > 0);
    }).detach();
    for (int tenths = 0; tenths < 10 * connectSeconds; ++tenths) {
        if (isKnown.wait_for(std::chrono::milliseconds(100)) == std::future_status::ready) {
            return isKnown.get() ? core::Status(core::Done{})
                                 : core::Error(says::archiveUnknownHost(node.host).about(node.name));
        }
        if (isStopWished()) {
            return stoppedLink(node);
        }
    }
    return core::Error(says::archiveUnknownHost(node.host).about(node.name));
}

void addContexts(T_ASC_Parameters* parameters, const std::vector<ProposedContext>& contexts)
{
    T_ASC_PresentationContextID id = 1;
    for (const ProposedContext& context : contexts) {
        std::vector<const char*> syntaxes;
        for (const std::string& syntax : context.transferSyntaxes) {
            syntaxes.push_back(syntax.c_str());
        }
        ASC_addPresentationContext(parameters, id, context.abstractSyntax.c_str(), syntaxes.data(),
                                   static_cast<int>(syntaxes.size()),
                                   context.isForReceiving ? ASC_SC_ROLE_SCP : ASC_SC_ROLE_DEFAULT);
        id = static_cast<T_ASC_PresentationContextID>(id + 2);
    }
}

std::vector<AcceptedContext> acceptedContexts(T_ASC_Association* association)
{
    std::vector<AcceptedContext> accepted;
    const int count = ASC_countPresentationContexts(association->params);
    for (int i = 0; i < count; ++i) {
        T_ASC_PresentationContext context{};
        if (ASC_getPresentationContext(association->params, i, &context).good() &&
            context.resultReason == ASC_P_ACCEPTANCE) {
            accepted.push_back({context.presentationContextID, context.abstractSyntax, context.acceptedTransferSyntax});
        }
    }
    return accepted;
}

core::Status checkPeerHost(T_ASC_Association* association, const ArchiveNode& node)
{
    if (!node.isTls || !node.checksHost) {
        return core::Done{};
    }
    std::string certificate(ASC_getPeerCertificateLength(association), '\0');
    certificate.resize(ASC_getPeerCertificate(association, certificate.data(), certificate.size()));
    return isCertificateOf(certificate, node.host) ? core::Status(core::Done{})
                                                   : core::Error(says::archiveTlsHost(node.host).about(node.name));
}

}   // namespace

struct DimseLink::Parts {
    ArchiveNode node;
    StopQuestion isStopWished;
    TransportLayer tls;   // outlives the network that uses it
    T_ASC_Network* network = nullptr;
    T_ASC_Association* association = nullptr;
    std::vector<AcceptedContext> contexts;
    bool isOver = false;   ///< nothing is to be told to the peer any more

    Parts() = default;
    Parts(const Parts&) = delete;
    Parts& operator=(const Parts&) = delete;
    ~Parts()
    {
        if (association != nullptr) {
            if (!isOver) {
                ASC_abortAssociation(association);
            }
            ASC_destroyAssociation(&association);
        }
        if (network != nullptr) {
            ASC_dropNetwork(&network);
        }
    }

    core::Status request(const std::vector<ProposedContext>& proposed);
    core::Error failure(const OFCondition& condition)
    {
        isOver = isOver || isConnectionGone(condition);
        return associationFailure(condition, node);
    }

    core::Status write(std::uint8_t context, DUL_DATAPDV kind, std::string_view bytes, bool isLast);
    core::Result<std::optional<DUL_PDV>> read(const LifeQuestion& isAlive);
    core::Status waitForData(const LifeQuestion& isAlive);
};

core::Status DimseLink::Parts::request(const std::vector<ProposedContext>& proposed)
{
    if (const OFCondition made = ASC_initializeNetwork(NET_REQUESTOR, 0, node.answerSeconds, &network); made.bad()) {
        return failure(made);
    }
    if (node.isTls) {
        auto layer = makeTlsLayer({node.caFile, node.certificateFile, node.keyFile}, TlsRole::Asks);
        if (!layer) {
            return layer.error().about(node.name);
        }
        tls = std::move(layer).value();
        ASC_setTransportLayer(network, tls.get(), 0);
    }
    T_ASC_Parameters* parameters = nullptr;
    if (const OFCondition made = ASC_createAssociationParameters(&parameters, pduBytes); made.bad()) {
        return failure(made);
    }
    ASC_setTransportLayerType(parameters, node.isTls ? OFTrue : OFFalse);
    ASC_setAPTitles(parameters, node.ownTitle.c_str(), node.title.c_str(), nullptr);
    ASC_setPresentationAddresses(parameters, OFStandard::getHostName().c_str(), addressOf(node).c_str());
    addContexts(parameters, proposed);
    const OFCondition requested =
        ASC_requestAssociation(network, parameters, &association, nullptr, nullptr, DUL_NOBLOCK, node.answerSeconds);
    if (requested.bad()) {
        isOver = true;
        const core::Error error = requestFailure(requested, parameters, node);
        if (association == nullptr) {
            ASC_destroyAssociationParameters(&parameters);
        }
        return error;
    }
    contexts = acceptedContexts(association);
    return checkPeerHost(association, node);
}

core::Status DimseLink::Parts::write(std::uint8_t context, DUL_DATAPDV kind, std::string_view bytes, bool isLast)
{
    DUL_PDV pdv{};
    pdv.fragmentLength = bytes.size();
    pdv.presentationContextID = context;
    pdv.pdvType = kind;
    pdv.lastPDV = isLast ? OFTrue : OFFalse;
    pdv.data = const_cast<char*>(bytes.data());
    DUL_PDVLIST list{};
    list.count = 1;
    list.pdv = &pdv;
    const OFCondition written = DUL_WritePDVs(&association->DULassociation, &list);
    return written.good() ? core::Status(core::Done{}) : core::Status(failure(written));
}

core::Status DimseLink::Parts::waitForData(const LifeQuestion& isAlive)
{
    using Clock = std::chrono::steady_clock;
    const auto limit = std::chrono::seconds(node.answerSeconds);
    for (auto begun = Clock::now(); Clock::now() - begun < limit;) {
        if (isStopWished()) {
            return stoppedLink(node);
        }
        if (ASC_dataWaiting(association, 1)) {
            return core::Done{};
        }
        if (isAlive && isAlive()) {
            begun = Clock::now();
        }
    }
    return core::Error(says::archiveNoAnswer(core::Quantity{double(node.answerSeconds), 0, "s"}).about(node.name));
}

core::Result<std::optional<DUL_PDV>> DimseLink::Parts::read(const LifeQuestion& isAlive)
{
    DUL_PDV pdv{};
    if (DUL_NextPDV(&association->DULassociation, &pdv).good()) {
        return std::optional(pdv);
    }
    if (auto there = waitForData(isAlive); !there) {
        return there.error();
    }
    const OFCondition came = DUL_ReadPDVs(&association->DULassociation, nullptr, DUL_NOBLOCK, node.answerSeconds);
    if (came == DUL_PEERREQUESTEDRELEASE) {
        ASC_acknowledgeRelease(association);
        isOver = true;
        return std::optional<DUL_PDV>();
    }
    if (came != DUL_PDATAPDUARRIVED) {
        return failure(came);
    }
    const OFCondition next = DUL_NextPDV(&association->DULassociation, &pdv);
    return next.good() ? core::Result<std::optional<DUL_PDV>>(std::optional(pdv)) : failure(next);
}

DimseLink::DimseLink(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
DimseLink::DimseLink(DimseLink&& other) noexcept = default;
DimseLink::~DimseLink() = default;

core::Result<DimseLink> DimseLink::open(const ArchiveNode& node, const std::vector<ProposedContext>& contexts,
                                        StopQuestion isStopWished)
{
    if (auto checked = checkNode(node); !checked) {
        return checked.error();
    }
    if (node.host.empty()) {
        return core::Error(says::archiveNoDimse().about(node.name));
    }
    prepareNetwork(node.answerSeconds);
    if (auto resolved = resolveHost(node, isStopWished); !resolved) {
        return resolved.error();
    }
    auto parts = std::make_unique<Parts>();
    parts->node = node;
    parts->isStopWished = std::move(isStopWished);
    if (auto requested = parts->request(contexts); !requested) {
        return requested.error();
    }
    return DimseLink(std::move(parts));
}

DimseLink DimseLink::accepted(T_ASC_Association* association, const ArchiveNode& peer, StopQuestion isStopWished)
{
    auto parts = std::make_unique<Parts>();
    parts->node = peer;
    parts->isStopWished = std::move(isStopWished);
    parts->association = association;
    parts->contexts = acceptedContexts(association);
    return DimseLink(std::move(parts));
}

std::optional<AcceptedContext> DimseLink::contextFor(const std::string& abstractSyntax,
                                                     const std::string& transferSyntax) const
{
    for (const AcceptedContext& context : parts_->contexts) {
        if (context.abstractSyntax == abstractSyntax &&
            (transferSyntax.empty() || context.transferSyntax == transferSyntax)) {
            return context;
        }
    }
    return std::nullopt;
}

std::optional<AcceptedContext> DimseLink::contextOf(std::uint8_t id) const
{
    for (const AcceptedContext& context : parts_->contexts) {
        if (context.id == id) {
            return context;
        }
    }
    return std::nullopt;
}

core::Status DimseLink::send(std::uint8_t context, const DimseCommand& command)
{
    return parts_->write(context, DUL_COMMANDPDV, command.encoded(), true);
}

core::Status DimseLink::sendPieces(std::uint8_t context, const PieceSource& next)
{
    for (bool isLast = false; !isLast;) {
        if (parts_->isStopWished()) {
            return stoppedLink(parts_->node);
        }
        auto piece = next(parts_->association->sendPDVLength);
        if (!piece) {
            return piece.error();
        }
        isLast = piece.value().isLast;
        if (auto sent = parts_->write(context, DUL_DATASETPDV, piece.value().bytes, isLast); !sent) {
            return sent;
        }
    }
    return core::Done{};
}

core::Status DimseLink::sendData(std::uint8_t context, std::string_view data)
{
    return sendPieces(context, [&data](std::size_t mostBytes) -> core::Result<Piece> {
        Piece piece{data.substr(0, mostBytes), data.size() <= mostBytes};
        data.remove_prefix(piece.bytes.size());
        return piece;
    });
}

core::Result<std::optional<DimseLink::Received>> DimseLink::receive(const LifeQuestion& isAlive)
{
    std::string bytes;
    for (;;) {
        auto read = parts_->read(isAlive);
        if (!read) {
            return read.error();
        }
        if (!read.value()) {
            return std::optional<Received>();
        }
        const DUL_PDV& pdv = *read.value();
        if (pdv.pdvType != DUL_COMMANDPDV || bytes.size() + pdv.fragmentLength > mostCommandBytes) {
            return core::Error(says::archiveNonsense("DIMSE").about(parts_->node.name));
        }
        bytes.append(static_cast<const char*>(pdv.data), pdv.fragmentLength);
        if (pdv.lastPDV) {
            const auto command = DimseCommand::decode(bytes);
            return command ? core::Result<std::optional<Received>>(Received{*command, pdv.presentationContextID})
                           : core::Error(says::archiveNonsense("DIMSE").about(parts_->node.name));
        }
    }
}

core::Status DimseLink::receivePieces(const PieceSink& take)
{
    for (;;) {
        auto read = parts_->read({});
        if (!read) {
            return read.error();
        }
        if (!read.value() || read.value()->pdvType != DUL_DATASETPDV) {
            return core::Error(says::archiveNonsense("DIMSE").about(parts_->node.name));
        }
        const DUL_PDV& pdv = *read.value();
        if (parts_->isStopWished()) {
            return stoppedLink(parts_->node);
        }
        if (auto taken = take({static_cast<const char*>(pdv.data), pdv.fragmentLength}); !taken) {
            return taken;
        }
        if (pdv.lastPDV) {
            return core::Done{};
        }
    }
}

core::Result<std::string> DimseLink::receiveData()
{
    std::string data;
    auto received = receivePieces([this, &data](std::string_view piece) -> core::Status {
        if (data.size() + piece.size() > mostAnswerBytes) {
            return core::Error(says::archiveNonsense("DIMSE").about(parts_->node.name));
        }
        data += piece;
        return core::Done{};
    });
    return received ? core::Result<std::string>(std::move(data)) : core::Result<std::string>(received.error());
}

void DimseLink::release()
{
    if (!std::exchange(parts_->isOver, true)) {
        ASC_releaseAssociation(parts_->association);
    }
}

void prepareNetwork(int answerSeconds)
{
    quietLibraries();
    OFStandard::initializeNetwork();
    dcmConnectionTimeout.set(connectSeconds);
    dcmSocketSendTimeout.set(answerSeconds);
    dcmSocketReceiveTimeout.set(answerSeconds);
    dcmDisableGethostbyaddr.set(OFTrue);
}

}   // namespace angiopose::io
