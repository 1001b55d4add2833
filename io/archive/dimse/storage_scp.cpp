#include "io/archive/dimse/storage_scp.h"

#include "io/archive/dimse/association_failure.h"
#include "io/archive/dimse/receive_object.h"
#include "io/archive/dimse/storage_classes.h"
#include "io/messages/messages.h"

#include <dcmtk/config/osconfig.h>
// DCMTK headers must come first because of their macros.
#include <dcmtk/dcmnet/assoc.h>
#include <dcmtk/dcmnet/dul.h>
#include <algorithm>
#include <array>

namespace angiopose::io {
namespace {

/// The peer that requests an association.
struct Caller {
    std::string title;
    std::string calledTitle;
    std::string address;
};

std::string unpadded(std::string text)
{
    text.erase(text.find_last_not_of(' ') + 1);
    return text;
}

Caller callerOf(T_ASC_Association* association)
{
    std::array<char, 128> calling{}, called{}, responding{}, from{}, to{};
    ASC_getAPTitles(association->params, calling.data(), calling.size(), called.data(), called.size(),
                    responding.data(), responding.size());
    ASC_getPresentationAddresses(association->params, from.data(), from.size(), to.data(), to.size());
    return {unpadded(calling.data()), unpadded(called.data()), from.data()};
}

bool isListed(const std::vector<std::string>& allowed, const std::string& value)
{
    return allowed.empty() || std::ranges::find(allowed, value) != allowed.end();
}

void reject(T_ASC_Association* association, T_ASC_RejectParametersReason reason)
{
    T_ASC_RejectParameters parameters{ASC_RESULT_REJECTEDPERMANENT, ASC_SOURCE_SERVICEUSER, reason};
    ASC_rejectAssociation(association, &parameters);
}

/// Returns the first proposed transfer syntax that we accept; null if there is none.
const char* supportedSyntaxOf(const T_ASC_PresentationContext& context)
{
    for (int i = 0; i < context.transferSyntaxCount; ++i) {
        for (const char* syntax : supportedTransferSyntaxes()) {
            if (std::string_view(syntax) == context.proposedTransferSyntaxes[i]) {
                return syntax;
            }
        }
    }
    return nullptr;
}

void answerContexts(T_ASC_Association* association)
{
    const int count = ASC_countPresentationContexts(association->params);
    for (int i = 0; i < count; ++i) {
        T_ASC_PresentationContext context{};
        if (ASC_getPresentationContext(association->params, i, &context).bad()) {
            continue;
        }
        const std::string_view wanted = context.abstractSyntax;
        const bool isServed = wanted == sop::verification || wanted.starts_with(sop::storagePrefix);
        const char* syntax = supportedSyntaxOf(context);
        if (isServed && syntax != nullptr) {
            ASC_acceptPresentationContext(association->params, context.presentationContextID, syntax);
        } else {
            ASC_refusePresentationContext(
                association->params, context.presentationContextID,
                isServed ? ASC_P_TRANSFERSYNTAXESNOTSUPPORTED : ASC_P_ABSTRACTSYNTAXNOTSUPPORTED);
        }
    }
}

/// Returns whether an error concerns the store rather than a single peer and therefore stops the storage SCP.
bool isStoreError(const core::Error& error)
{
    const core::Message& message = error.message;
    return message.is(messages::archiveCacheTooSmall) || message.is(messages::archiveNoFolder) ||
           std::string_view(message.id()).starts_with("file.");
}

}   // namespace

struct StorageScp::Impl {
    StorageScpOptions options;
    TransportLayer tls;
    T_ASC_Network* network = nullptr;
    std::optional<core::Error> failure;

    Impl() = default;
    Impl(const Impl&) = delete;
    Impl& operator=(const Impl&) = delete;
    ~Impl()
    {
        if (network != nullptr) {
            ASC_dropNetwork(&network);
        }
    }

    core::Status begin();
    std::optional<DimseLink> acceptAssociation(StoreWriter& storeWriter, const StopCheck& isStopRequested);
    std::optional<DimseLink> checkCaller(T_ASC_Association* association, StoreWriter& storeWriter,
                                         const StopCheck& isStopRequested);
    core::Status receiveAll(DimseLink& link, StoreWriter& storeWriter) const;
};

core::Status StorageScp::Impl::begin()
{
    configureDcmtkNetwork(options.responseTimeoutSeconds);
    const OFCondition made =
        ASC_initializeNetwork(NET_ACCEPTOR, options.port, options.responseTimeoutSeconds, &network);
    if (made.bad()) {
        return core::Error(messages::archivePortTaken(options.port, made.text()));
    }
    if (options.isTls) {
        auto layer = makeTlsLayer(options.tls, TlsRole::Server);
        if (!layer) {
            return layer.error();
        }
        tls = std::move(layer).value();
        ASC_setTransportLayer(network, tls.get(), 0);
    }
    return core::Done{};
}

/// Accepts the next association if its caller is permitted; returns nullopt if none arrives within a second.
std::optional<DimseLink> StorageScp::Impl::acceptAssociation(StoreWriter& storeWriter, const StopCheck& isStopRequested)
{
    if (!ASC_associationWaiting(network, 1)) {
        return std::nullopt;
    }
    T_ASC_Association* association = nullptr;
    const OFCondition came = ASC_receiveAssociation(network, &association, ASC_MAXIMUMPDUSIZE, nullptr, nullptr,
                                                    options.isTls ? OFTrue : OFFalse, DUL_NOBLOCK,
                                                    std::min(options.responseTimeoutSeconds, 10));
    if (came.good()) {
        return checkCaller(association, storeWriter, isStopRequested);
    }
    storeWriter.warn(options.isTls ? messages::archiveCallNotSecured(came.text())
                                   : messages::archiveCallFailed(came.text()));
    if (association != nullptr) {
        ASC_dropAssociation(association);
        ASC_destroyAssociation(&association);
    }
    return std::nullopt;
}

std::optional<DimseLink> StorageScp::Impl::checkCaller(T_ASC_Association* association, StoreWriter& storeWriter,
                                                       const StopCheck& isStopRequested)
{
    const Caller caller = callerOf(association);
    const bool isCalledRight = options.ownAeTitle.empty() || caller.calledTitle == options.ownAeTitle;
    if (!isCalledRight || !isListed(options.titles, caller.title) || !isListed(options.hosts, caller.address)) {
        storeWriter.warn(isCalledRight
                             ? messages::archiveTitleTurnedAway(caller.address, caller.title)
                             : messages::archiveCalledOtherwise(caller.address, caller.title, caller.calledTitle));
        reject(association,
               isCalledRight ? ASC_REASON_SU_CALLINGAETITLENOTRECOGNIZED : ASC_REASON_SU_CALLEDAETITLENOTRECOGNIZED);
        ASC_dropAssociation(association);
        ASC_destroyAssociation(&association);
        return std::nullopt;
    }
    answerContexts(association);
    if (ASC_acknowledgeAssociation(association).bad()) {
        ASC_dropAssociation(association);
        ASC_destroyAssociation(&association);
        return std::nullopt;
    }
    ArchiveNode peer;
    peer.name = caller.title;
    peer.host = caller.address;
    peer.title = caller.title;
    peer.responseTimeoutSeconds = options.responseTimeoutSeconds;
    return DimseLink::accepted(association, peer, isStopRequested);
}

core::Status StorageScp::Impl::receiveAll(DimseLink& link, StoreWriter& storeWriter) const
{
    for (;;) {
        auto received = link.receive();
        if (!received) {
            return received.error();
        }
        if (!received.value()) {
            return core::Done{};
        }
        const DimseLink::ReceivedCommand& message = *received.value();
        core::Status done = core::Done{};
        if (message.command.kind() == DimseMessageType::EchoRequest) {
            done = link.send(message.context, message.command.response(dimse::success));
        } else if (message.command.kind() == DimseMessageType::StoreRequest) {
            done = receiveObject(link, message, options.expected, storeWriter);
        } else {
            done = core::Error(messages::archiveNonsense("C-STORE"));
        }
        if (!done) {
            return done;
        }
    }
}

StorageScp::StorageScp(std::unique_ptr<Impl> parts) : impl_(std::move(parts)) {}
StorageScp::StorageScp(StorageScp&&) noexcept = default;
StorageScp::~StorageScp() = default;

core::Status checkStorageScpOptions(const StorageScpOptions& options)
{
    std::vector<std::string> titles = options.titles;
    if (!options.ownAeTitle.empty()) {
        titles.push_back(options.ownAeTitle);
    }
    for (const std::string& title : titles) {
        if (!isAeTitle(title)) {
            return core::Error(messages::archiveBadTitle(title));
        }
    }
    if (options.isTls && (options.tls.certificateFile.empty() || options.tls.keyFile.empty())) {
        return core::Error(messages::archivePortUnsecured());
    }
    return core::Done{};
}

core::Result<StorageScp> StorageScp::listen(const StorageScpOptions& options)
{
    if (auto checked = checkStorageScpOptions(options); !checked) {
        return checked.error();
    }
    auto parts = std::make_unique<Impl>();
    parts->options = options;
    if (auto begun = parts->begin(); !begun) {
        return begun.error();
    }
    return StorageScp(std::move(parts));
}

void StorageScp::serve(StoreWriter& storeWriter, const StopCheck& isStopRequested)
{
    while (!isStopRequested() && !impl_->failure) {
        auto link = impl_->acceptAssociation(storeWriter, isStopRequested);
        if (!link) {
            continue;
        }
        const auto taken = impl_->receiveAll(*link, storeWriter);
        if (taken || taken.error().isCancellation()) {
            continue;
        }
        if (isStoreError(taken.error())) {
            impl_->failure = taken.error();
        } else {
            storeWriter.recordMissing(taken.error().message);
        }
    }
}

const std::optional<core::Error>& StorageScp::failure() const
{
    return impl_->failure;
}

}   // namespace angiopose::io
