#pragma once

#include "io/archive/dimse/link.h"
#include "io/archive/model/query.h"

#include <string>
#include <vector>

namespace angiopose::io {

/// Verifies by C-ECHO that the archive responds to its configured AE title.
core::Status dimseEcho(const ArchiveNode& node, const StopCheck& isStopRequested);

/// Queries studies and series by C-FIND (Study Root model).
core::Result<ArchiveMatches> dimseFind(const ArchiveNode& node, const ArchiveQuery& query,
                                       const StopCheck& isStopRequested);

/// Opens an association for C-FIND.
core::Result<DimseLink> openFindAssociation(const ArchiveNode& node, const StopCheck& isStopRequested);

core::Result<std::vector<std::string>> findSeries(DimseLink& link, const ArchiveNode& node,
                                                  const std::string& studyUid);
core::Result<std::vector<ArchiveObject>> findObjects(DimseLink& link, const ArchiveNode& node,
                                                     const std::string& studyUid, const std::string& seriesUid);

}   // namespace angiopose::io
