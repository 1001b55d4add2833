#pragma once

#include "core/support/result.h"
#include "io/archive/model/query.h"

#include <string>
#include <vector>

namespace angiopose::io {

/// Parses a QIDO-RS response (PS3.18 F); fails if the text is not an array of DICOM JSON objects.
core::Result<std::vector<ArchiveMatch>> parseMatches(const std::string& json);
core::Result<std::vector<ArchiveObject>> parseObjects(const std::string& json);

/// Result of STOW-RS for one sent object.
struct StoreResult {
    bool isStored = false;
    int failure = 0;   ///< failure reason (0008,1197); 0 if not reported
};
StoreResult parseStoreResult(const std::string& json);

}   // namespace angiopose::io
