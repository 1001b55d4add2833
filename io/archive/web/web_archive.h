#pragma once

#include "io/archive/model/node.h"
#include "io/archive/model/query.h"
#include "io/archive/store/sendable_file.h"
#include "io/archive/store/store_writer.h"

#include <functional>
#include <memory>
#include <vector>

namespace angiopose::io {

/// Verifies that the archive responds. These functions are the DICOMweb (PS3.18) counterparts of the DIMSE functions.
core::Status webEcho(const ArchiveNode& node, const std::function<bool()>& isStopRequested);

/// Queries studies and series by QIDO-RS.
core::Result<ArchiveMatches> webFind(const ArchiveNode& node, const ArchiveQuery& query,
                                     const std::function<bool()>& isStopRequested);

/// Creates a source that retrieves objects by WADO-RS in their stored transfer syntax.
std::unique_ptr<SeriesSource> makeWebSource(const ArchiveNode& node, const std::function<bool()>& isStopRequested);

/// Sends files by STOW-RS.
void webSend(const ArchiveNode& node, const std::vector<SendableFile>& files, const ArchiveObserver& observe,
             TransferReport& report);

}   // namespace angiopose::io
