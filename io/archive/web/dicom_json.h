#pragma once

#include "core/support/result.h"
#include "io/archive/model/query.h"

#include <string>
#include <vector>

namespace angiopose::io {

/// Parses QIDO-RS responses (PS3.18 F). Both functions fail if the text is not an array of such objects.
core::Result<std::vector<ArchiveMatch>> matchesOfJson(const std::string& json);
core::Result<std::vector<ArchiveObject>> objectsOfJson(const std::string& json);

/// The STOW-RS result for one object that was sent.
struct StoreAnswer {
    bool isStored = false;
    int failure = 0;   ///< FailureReason (0008,1197); 0: not reported
};
StoreAnswer storeAnswerOfJson(const std::string& json);

}   // namespace angiopose::io
