#pragma once

#include "io/archive/dimse/link.h"
#include "io/archive/model/node.h"
#include "io/archive/model/query.h"
#include "io/archive/store/sendable_file.h"
#include "io/archive/store/store_writer.h"

#include <memory>
#include <vector>

namespace angiopose::io {

/// Sends files by C-STORE, byte for byte as stored, each in its own transfer syntax. Counts the results in `report` and
/// sets `report.end` if sending stops early.
void dimseSend(const ArchiveNode& node, const std::vector<SendableFile>& files, const ArchiveObserver& observe,
               TransferReport& report);

/// Creates a source that retrieves objects by C-GET or, if the archive does not support that, by C-MOVE to our
/// receiving port.
std::unique_ptr<SeriesSource> makeDimseSource(const ArchiveNode& node, const StopCheck& isStopRequested);

}   // namespace angiopose::io
