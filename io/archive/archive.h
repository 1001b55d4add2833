#pragma once

#include "io/archive/model/node.h"
#include "io/archive/model/query.h"
#include "io/archive/store/arrivals.h"

#include <functional>
#include <string>
#include <vector>

namespace angiopose::io {

/// Which language an archive is spoken to in.
enum class ArchiveWay { Usual, Dimse, Web };

/// The usual one of a node: DIMSE where it has a host, else DICOMweb.
ArchiveWay wayTo(const ArchiveNode& node, ArchiveWay requested);

/// Whether the archive answers and lets us ask. Every failure of these names the archive, the problem and the remedy.
core::Status echoArchive(const ArchiveNode& node, ArchiveWay way, const ArchiveObserver& observe = {});

core::Result<ArchiveMatches> findInArchive(const ArchiveNode& node, ArchiveWay way, const ArchiveQuery& query,
                                           const ArchiveObserver& observe = {});

struct RetrieveRequest {
    std::string studyUid;
    std::vector<std::string> seriesUids;   ///< empty: all of the study
};

/// Into a store, of which `limit` says how much it may hold. Series that are there whole are not asked for again.
TransferReport retrieveFromArchive(const ArchiveNode& node, ArchiveWay way, const RetrieveRequest& request,
                                   const ObjectStore& store, const StoreLimit& limit,
                                   const ArchiveObserver& observe = {});

/// Files, and all files of folders. What is no DICOM file that can be sent is told as a problem.
TransferReport sendToArchive(const ArchiveNode& node, ArchiveWay way, const std::vector<std::string>& paths,
                             const ArchiveObserver& observe = {});

}   // namespace angiopose::io
