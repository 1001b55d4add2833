#pragma once

#include "core/support/result.h"
#include "io/archive/model/query.h"

#include <string>
#include <vector>

namespace angiopose::io {

/// Answers of QIDO-RS (PS3.18 F). Fail on what is no array of such objects.
core::Result<std::vector<ArchiveMatch>> matchesOfJson(const std::string& json);
core::Result<std::vector<ArchiveObject>> objectsOfJson(const std::string& json);

/// What STOW-RS says of one object that was sent.
struct StoreAnswer {
    bool isStored = false;
    int failure = 0;   ///< FailureReason (0008,1197); 0: not told
};
StoreAnswer storeAnswerOfJson(const std::string& json);

}   // namespace angiopose::io
