#include "io/archive/dimse/association.h"

#include "io/archive/dimse/association_failure.h"
#include "io/messages/messages.h"
#include "io/support/silence_libraries.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmnet/assoc.h>
#include <dcmtk/dcmnet/dcmtrans.h>
#include <dcmtk/dcmnet/dul.h>
#include <dcmtk/ofstd/ofsockad.h>
#include <dcmtk/ofstd/ofstd.h>
#include <chrono>
#include <future>
#include <memory>
#include <thread>
#include <utility>

namespace angiopose::io {
namespace {

constexpr long pduBytes = ASC_MAXIMUMPDUSIZE;

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
    if (!node.isTls || !node.verifiesHost) {
        return core::Done{};
    }
    std::string certificate(ASC_getPeerCertificateLength(association), '\0');
    certificate.resize(ASC_getPeerCertificate(association, certificate.data(), certificate.size()));
    return isCertificateForHost(certificate, node.host)
               ? core::Status(core::Done{})
               : core::Error(messages::archiveTlsHost(node.host).about(node.name));
}

PresentationDataValue valueOf(const DUL_PDV& pdv)
{
    return {pdv.pdvType == DUL_COMMANDPDV ? PresentationDataValue::Kind::Command : PresentationDataValue::Kind::DataSet,
            pdv.presentationContextID,
            {static_cast<const char*>(pdv.data), pdv.fragmentLength},
            pdv.lastPDV != OFFalse};
}

}   // namespace

void configureDcmtkNetwork(int responseTimeoutSeconds)
{
    silenceLibraries();
    OFStandard::initializeNetwork();
    dcmConnectionTimeout.set(connectTimeoutSeconds);
    dcmSocketSendTimeout.set(responseTimeoutSeconds);
    dcmSocketReceiveTimeout.set(responseTimeoutSeconds);
    dcmDisableGethostbyaddr.set(OFTrue);
}

core::Status resolveHost(const ArchiveNode& node, const StopCheck& isStopRequested)
{
    // Without a network, name resolution may block for half a minute, so it runs in a detached thread.
    auto promise = std::make_shared<std::promise<bool>>();
    auto isKnown = promise->get_future();
    std::thread([promise, host = node.host] {
        OFSockAddr address;
        OFStandard::getAddressByHostname(host.c_str(), address);
        promise->set_value(address.size() > 0);
    }).detach();
    for (int tenths = 0; tenths < 10 * connectTimeoutSeconds; ++tenths) {
        if (isKnown.wait_for(std::chrono::milliseconds(100)) == std::future_status::ready) {
            return isKnown.get() ? core::Status(core::Done{})
                                 : core::Error(messages::archiveUnknownHost(node.host).about(node.name));
        }
        if (isStopRequested()) {
            return canceledAssociationError(node);
        }
    }
    return core::Error(messages::archiveUnknownHost(node.host).about(node.name));
}

Association::Association(const ArchiveNode& node, StopCheck isStopRequested)
    : node_(node), isStopRequested_(std::move(isStopRequested))
{
}

Association::Association(T_ASC_Association* accepted, const ArchiveNode& peer, StopCheck isStopRequested)
    : node_(peer),
      isStopRequested_(std::move(isStopRequested)),
      association_(accepted),
      contexts_(acceptedContexts(accepted))
{
}

Association::~Association()
{
    if (association_ != nullptr) {
        if (!isClosed_) {
            ASC_abortAssociation(association_);
        }
        ASC_destroyAssociation(&association_);
    }
    if (network_ != nullptr) {
        ASC_dropNetwork(&network_);
    }
}

core::Result<std::unique_ptr<Association>> Association::request(const ArchiveNode& node,
                                                                const std::vector<ProposedContext>& contexts,
                                                                StopCheck isStopRequested)
{
    configureDcmtkNetwork(node.responseTimeoutSeconds);
    if (auto resolved = resolveHost(node, isStopRequested); !resolved) {
        return resolved.error();
    }
    std::unique_ptr<Association> made(new Association(node, std::move(isStopRequested)));
    if (auto connected = made->connect(contexts); !connected) {
        return connected.error();
    }
    return made;
}

core::Status Association::connect(const std::vector<ProposedContext>& contexts)
{
    if (const OFCondition made = ASC_initializeNetwork(NET_REQUESTOR, 0, node_.responseTimeoutSeconds, &network_);
        made.bad()) {
        return failure(made);
    }
    if (node_.isTls) {
        auto layer = makeTlsLayer({node_.caFile, node_.certificateFile, node_.keyFile}, TlsRole::Client);
        if (!layer) {
            return layer.error().about(node_.name);
        }
        tls_ = std::move(layer).value();
        ASC_setTransportLayer(network_, tls_.get(), 0);
    }
    T_ASC_Parameters* parameters = nullptr;
    if (const OFCondition made = ASC_createAssociationParameters(&parameters, pduBytes); made.bad()) {
        return failure(made);
    }
    ASC_setTransportLayerType(parameters, node_.isTls ? OFTrue : OFFalse);
    ASC_setAPTitles(parameters, node_.ownAeTitle.c_str(), node_.title.c_str(), nullptr);
    ASC_setPresentationAddresses(parameters, OFStandard::getHostName().c_str(), hostAndPort(node_).c_str());
    addContexts(parameters, contexts);
    const OFCondition requested = ASC_requestAssociation(network_, parameters, &association_, nullptr, nullptr,
                                                         DUL_NOBLOCK, node_.responseTimeoutSeconds);
    if (requested.bad()) {
        isClosed_ = true;
        const core::Error error = associationRequestError(requested, parameters, node_);
        if (association_ == nullptr) {
            ASC_destroyAssociationParameters(&parameters);
        }
        return error;
    }
    contexts_ = acceptedContexts(association_);
    return checkPeerHost(association_, node_);
}

std::size_t Association::maxFragmentBytes() const
{
    return association_->sendPDVLength;
}

core::Status Association::write(const PresentationDataValue& value)
{
    DUL_PDV pdv{};
    pdv.fragmentLength = value.bytes.size();
    pdv.presentationContextID = value.context;
    pdv.pdvType = value.kind == PresentationDataValue::Kind::Command ? DUL_COMMANDPDV : DUL_DATASETPDV;
    pdv.lastPDV = value.isLast ? OFTrue : OFFalse;
    pdv.data = const_cast<char*>(value.bytes.data());
    DUL_PDVLIST list{};
    list.count = 1;
    list.pdv = &pdv;
    const OFCondition written = DUL_WritePDVs(&association_->DULassociation, &list);
    return written.good() ? core::Status(core::Done{}) : core::Status(failure(written));
}

core::Result<std::optional<PresentationDataValue>> Association::read(const ActivityCheck& hasActivity)
{
    DUL_PDV pdv{};
    if (DUL_NextPDV(&association_->DULassociation, &pdv).good()) {
        return std::optional(valueOf(pdv));
    }
    if (auto there = waitForData(hasActivity); !there) {
        return there.error();
    }
    const OFCondition came =
        DUL_ReadPDVs(&association_->DULassociation, nullptr, DUL_NOBLOCK, node_.responseTimeoutSeconds);
    if (came == DUL_PEERREQUESTEDRELEASE) {
        ASC_acknowledgeRelease(association_);
        isClosed_ = true;
        return std::optional<PresentationDataValue>();
    }
    if (came != DUL_PDATAPDUARRIVED) {
        return failure(came);
    }
    const OFCondition next = DUL_NextPDV(&association_->DULassociation, &pdv);
    return next.good() ? core::Result<std::optional<PresentationDataValue>>(std::optional(valueOf(pdv)))
                       : failure(next);
}

void Association::release()
{
    if (!std::exchange(isClosed_, true)) {
        ASC_releaseAssociation(association_);
    }
}

core::Status Association::waitForData(const ActivityCheck& hasActivity) const
{
    using Clock = std::chrono::steady_clock;
    const auto limit = std::chrono::seconds(node_.responseTimeoutSeconds);
    for (auto begun = Clock::now(); Clock::now() - begun < limit;) {
        if (isStopRequested_()) {
            return canceledAssociationError(node_);
        }
        if (ASC_dataWaiting(association_, 1)) {
            return core::Done{};
        }
        if (hasActivity && hasActivity()) {
            begun = Clock::now();
        }
    }
    return core::Error(
        messages::archiveNoAnswer(core::Quantity{double(node_.responseTimeoutSeconds), 0, "s"}).about(node_.name));
}

core::Error Association::failure(const OFCondition& condition)
{
    isClosed_ = isClosed_ || isConnectionClosed(condition);
    return associationError(condition, node_);
}

}   // namespace angiopose::io
