#pragma once

#include "io/archive/dimse/link.h"
#include "io/archive/model/node.h"
#include "io/archive/model/query.h"
#include "io/archive/store/arrivals.h"
#include "io/archive/store/sendable_file.h"

#include <memory>
#include <vector>

namespace angiopose::io {

/// C-STORE, each file in its own transfer syntax, byte by byte as it is stored. Counts into `report`; what ends it
/// early is its `end`.
void dimseSend(const ArchiveNode& node, const std::vector<SendableFile>& files, const ArchiveObserver& observe,
               TransferReport& report);

/// Objects by C-GET; where the archive does not offer that, by C-MOVE to a port of ours.
std::unique_ptr<SeriesSource> makeDimseSource(const ArchiveNode& node, const StopQuestion& isStopRequested);

}   // namespace angiopose::io
