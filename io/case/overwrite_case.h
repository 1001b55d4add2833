#pragma once

#include "core/case/case.h"
#include "core/support/result.h"

#include <string>

namespace angiopose::io {

/// Returns the SHA-256 of the case file as it is on disk now; empty if the file cannot be read.
std::string caseFileHash(const std::string& path);

/// Overwrites a case file that was opened or saved before, as `saveCase` does. `knownSha256` is the earlier result of
/// `caseFileHash`; if empty, nothing is compared. If another program has changed the file, fails with
/// `case.changed-elsewhere` and writes nothing; programs that save into the same folder wait for each other. Returns
/// the new hash.
core::Result<std::string> overwriteCase(const core::Case& session, const std::string& path,
                                        const std::string& knownSha256);

/// Returns whether an error means that another program changed the case.
bool isConcurrentChange(const core::Error& error);

}   // namespace angiopose::io
