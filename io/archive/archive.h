#pragma once

#include "io/archive/model/node.h"
#include "io/archive/model/query.h"
#include "io/archive/store/arrivals.h"

#include <functional>
#include <string>
#include <vector>

namespace angiopose::io {

/// The protocol used for an archive.
enum class ArchiveWay { Usual, Dimse, Web };

/// Resolves `Usual` to the node's default protocol: DIMSE if it has a host, otherwise DICOMweb.
ArchiveWay wayTo(const ArchiveNode& node, ArchiveWay requested);

/// Verifies that the archive responds and accepts our requests. All functions of this file name the archive, the
/// problem and the remedy in their errors.
core::Status echoArchive(const ArchiveNode& node, ArchiveWay way, const ArchiveObserver& observe = {});

core::Result<ArchiveMatches> findInArchive(const ArchiveNode& node, ArchiveWay way, const ArchiveQuery& query,
                                           const ArchiveObserver& observe = {});

struct RetrieveRequest {
    std::string studyUid;
    std::vector<std::string> seriesUids;   ///< empty: all series of the study
};

/// Retrieves series into a store within its `limit`. Skips series that are already complete there.
TransferReport retrieveFromArchive(const ArchiveNode& node, ArchiveWay way, const RetrieveRequest& request,
                                   const ObjectStore& store, const StoreLimit& limit,
                                   const ArchiveObserver& observe = {});

/// Sends files and the DICOM files of folders. Reports each file that is not sendable DICOM as a problem.
TransferReport sendToArchive(const ArchiveNode& node, ArchiveWay way, const std::vector<std::string>& paths,
                             const ArchiveObserver& observe = {});

}   // namespace angiopose::io
