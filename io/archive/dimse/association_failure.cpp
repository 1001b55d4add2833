#include "io/archive/dimse/association_failure.h"

#include "io/messages/says_archive.h"

#include <dcmtk/config/osconfig.h>
// DCMTK headers come first because of their macros.
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

/// Returns the text after the last colon of DCMTK's message, which is the system's own error text.
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
            return says::archiveUnknownTitle(node.title, addressOf(node));
        }
        if (reject.reason == ASC_REASON_SU_CALLINGAETITLENOTRECOGNIZED) {
            return says::archiveTitleNotAllowed(node.ownTitle);
        }
        if (reject.reason == ASC_REASON_SP_PRES_TEMPORARYCONGESTION) {
            return says::archiveRefused("temporary congestion");
        }
        if (reject.reason == ASC_REASON_SP_PRES_LOCALLIMITEXCEEDED) {
            return says::archiveRefused("local limit exceeded");
        }
    }
    return says::archiveRefused("no reason given");
}

bool isTlsFailure(const OFCondition& condition)
{
    return condition.code() == DULC_TLSERROR || condition.module() == OFM_dcmtls;
}

}   // namespace

core::Error requestFailure(const OFCondition& condition, T_ASC_Parameters* parameters, const ArchiveNode& node)
{
    const auto about = [&node](const core::Message& problem) { return core::Error(problem.about(node.name)); };
    if (isTlsFailure(condition)) {
        return about(says::archiveTlsRefused(lastPart(condition)));
    }
    switch (condition.code()) {
        case DULC_ASSOCIATIONREJECTED:
            return about(rejection(parameters, node));
        case DULC_UNKNOWNHOST:
            return about(says::archiveUnknownHost(node.host));
        case DULC_TCPINITERROR:
            return about(says::archiveNoConnection(addressOf(node), lastPart(condition)));
        case DULC_READTIMEOUT:
            return about(says::archiveSilent(addressOf(node), seconds(node.answerSeconds)));
        case DULC_PEERABORTEDASSOCIATION:
        case DULC_NETWORKCLOSED:
            return about(says::archiveRefused(lastPart(condition)));
        default:
            return about(says::archiveNonsense(lastPart(condition)));
    }
}

core::Error associationFailure(const OFCondition& condition, const ArchiveNode& node)
{
    const auto about = [&node](const core::Message& problem) { return core::Error(problem.about(node.name)); };
    switch (condition.code()) {
        case DULC_READTIMEOUT:
            return about(says::archiveNoAnswer(seconds(node.answerSeconds)));
        case DULC_PEERABORTEDASSOCIATION:
            return about(says::archiveAborted());
        default:
            return about(says::archiveBroken(lastPart(condition)));
    }
}

core::Error stoppedAssociation(const ArchiveNode& node)
{
    return core::Error(core::Stopped{says::archiveStopped()}).about(node.name);
}

bool isConnectionGone(const OFCondition& condition)
{
    return condition.code() == DULC_PEERABORTEDASSOCIATION || condition.code() == DULC_NETWORKCLOSED ||
           condition.code() == DULC_TCPIOERROR;
}

}   // namespace angiopose::io
