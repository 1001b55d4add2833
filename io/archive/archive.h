#pragma once

#include "io/archive/model/node.h"
#include "io/archive/model/query.h"
#include "io/archive/store/store_writer.h"

#include <functional>
#include <string>
#include <vector>

namespace angiopose::io {

/// Protocol used to access an archive.
enum class ArchiveProtocol { Default, Dimse, Web };

/// Resolves `Default` to the node's default protocol: DIMSE if it has a host, otherwise DICOMweb.
ArchiveProtocol protocolFor(const ArchiveNode& node, ArchiveProtocol requested);

/// Verifies that the archive responds and accepts our requests. The errors of all functions in this file name the
/// archive, the problem and the remedy.
core::Status echoArchive(const ArchiveNode& node, ArchiveProtocol protocol, const ArchiveObserver& observe = {});

core::Result<ArchiveMatches> queryArchive(const ArchiveNode& node, ArchiveProtocol protocol, const ArchiveQuery& query,
                                          const ArchiveObserver& observe = {});

struct RetrieveRequest {
    std::string studyUid;
    std::vector<std::string> seriesUids;   ///< if empty, all series of the study
};

/// Retrieves series into a store, up to its size limit. Skips series that are already complete in the store.
TransferReport retrieveFromArchive(const ArchiveNode& node, ArchiveProtocol protocol, const RetrieveRequest& request,
                                   const ObjectStore& store, const StoreLimit& limit,
                                   const ArchiveObserver& observe = {});

/// Sends the given files and the DICOM files of the given folders. Reports each file that cannot be sent as a problem.
TransferReport sendToArchive(const ArchiveNode& node, ArchiveProtocol protocol, const std::vector<std::string>& paths,
                             const ArchiveObserver& observe = {});

}   // namespace angiopose::io
