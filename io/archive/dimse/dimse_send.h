#pragma once

#include "io/archive/model/node.h"
#include "io/archive/model/transfer.h"
#include "io/archive/store/sendable_file.h"

#include <vector>

namespace angiopose::io {

/// C-STORE, each file in its own transfer syntax, byte by byte as it is stored. Counts into `report`; what ends it
/// early is its `end`.
void dimseSend(const ArchiveNode& node, const std::vector<SendableFile>& files, const ArchiveObserver& observe,
               TransferReport& report);

}   // namespace angiopose::io
