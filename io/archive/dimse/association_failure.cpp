#include "io/archive/dimse/association_failure.h"

#include "io/messages/messages.h"

#include <dcmtk/config/osconfig.h>
// DCMTK headers must come first because of their macros.
#include <dcmtk/dcmnet/assoc.h>
#include <dcmtk/dcmnet/cond.h>
#include <string>
#include <string_view>

namespace angiopose::io {
namespace {

core::Quantity seconds(int count)
{
    return {static_cast<double>(count), 0, "s"};
}

/// Returns the part of DCMTK's message after the last colon: the error text of the operating system.
std::string lastPart(const OFCondition& condition)
{
    const std::string_view text = condition.text();
    const std::size_t colon = text.rfind(": ");
    return std::string(colon == std::string_view::npos ? text : text.substr(colon + 2));
}

core::Message rejection(T_ASC_Parameters* parameters, const ArchiveNode& node)
{
    T_ASC_RejectParameters reject{};
    if (ASC_getRejectParameters(parameters, &reject).good()) {
        if (reject.reason == ASC_REASON_SU_CALLEDAETITLENOTRECOGNIZED) {
            return messages::archiveUnknownTitle(node.title, hostAndPort(node));
        }
        if (reject.reason == ASC_REASON_SU_CALLINGAETITLENOTRECOGNIZED) {
            return messages::archiveTitleNotAllowed(node.ownAeTitle);
        }
        if (reject.reason == ASC_REASON_SP_PRES_TEMPORARYCONGESTION) {
            return messages::archiveRefused("temporary congestion");
        }
        if (reject.reason == ASC_REASON_SP_PRES_LOCALLIMITEXCEEDED) {
            return messages::archiveRefused("local limit exceeded");
        }
    }
    return messages::archiveRefused("no reason given");
}

bool isTlsFailure(const OFCondition& condition)
{
    return condition.code() == DULC_TLSERROR || condition.module() == OFM_dcmtls;
}

}   // namespace

core::Error associationRequestError(const OFCondition& condition, T_ASC_Parameters* parameters, const ArchiveNode& node)
{
    const auto about = [&node](const core::Message& problem) { return core::Error(problem.about(node.name)); };
    if (isTlsFailure(condition)) {
        return about(messages::archiveTlsRefused(lastPart(condition)));
    }
    switch (condition.code()) {
        case DULC_ASSOCIATIONREJECTED:
            return about(rejection(parameters, node));
        case DULC_UNKNOWNHOST:
            return about(messages::archiveUnknownHost(node.host));
        case DULC_TCPINITERROR:
            return about(messages::archiveNoConnection(hostAndPort(node), lastPart(condition)));
        case DULC_READTIMEOUT:
            return about(messages::archiveSilent(hostAndPort(node), seconds(node.responseTimeoutSeconds)));
        case DULC_PEERABORTEDASSOCIATION:
        case DULC_NETWORKCLOSED:
            return about(messages::archiveRefused(lastPart(condition)));
        default:
            return about(messages::archiveNonsense(lastPart(condition)));
    }
}

core::Error associationError(const OFCondition& condition, const ArchiveNode& node)
{
    const auto about = [&node](const core::Message& problem) { return core::Error(problem.about(node.name)); };
    switch (condition.code()) {
        case DULC_READTIMEOUT:
            return about(messages::archiveNoAnswer(seconds(node.responseTimeoutSeconds)));
        case DULC_PEERABORTEDASSOCIATION:
            return about(messages::archiveAborted());
        default:
            return about(messages::archiveBroken(lastPart(condition)));
    }
}

core::Error canceledAssociationError(const ArchiveNode& node)
{
    return core::Error(core::Cancellation{messages::archiveStopped()}).about(node.name);
}

bool isConnectionClosed(const OFCondition& condition)
{
    return condition.code() == DULC_PEERABORTEDASSOCIATION || condition.code() == DULC_NETWORKCLOSED ||
           condition.code() == DULC_TCPIOERROR;
}

}   // namespace angiopose::io
