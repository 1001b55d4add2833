#pragma once

#include "io/archive/dimse/get_series.h"
#include "io/archive/dimse/identifier.h"
#include "io/messages/says_archive.h"

namespace angiopose::io {

inline std::string seriesIdentifier(const SeriesWish& wish)
{
    return encodedIdentifier({{0x00080052, "SERIES"}, {0x0020000d, wish.studyUid}, {0x0020000e, wish.seriesUid}});
}

/// Whether the last answer of a retrieval says that all was sent; where objects failed, that is noted by their absence.
inline core::Status settleRetrieval(const ArchiveNode& node, const std::string& service, const DimseCommand& answer)
{
    const std::uint16_t status = answer.status();
    if (status == dimse::success || status == dimse::someFailed) {
        return core::Done{};
    }
    return core::Error(says::archiveStatus(service, statusText(answer)).about(node.name));
}

inline bool isPending(const DimseCommand& answer)
{
    return answer.status() == dimse::pending;
}

}   // namespace angiopose::io
