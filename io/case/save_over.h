#pragma once

#include "core/case/case.h"
#include "core/support/result.h"

#include <string>

namespace angiopose::io {

/// SHA-256 of a case file as it lies there; empty where there is none that can be read.
std::string contentOfCaseFile(const std::string& path);

/// Writes a case (`saveCase`) over the file that was opened or saved before: `knownSha256` is what `contentOfCaseFile`
/// told then, empty: nothing is known and nothing compared. Fails with `case.changed-elsewhere`, nothing written, where
/// another program has changed it since; programs that save into one folder take turns. Returns what is known from now
/// on.
core::Result<std::string> saveCaseOver(const core::Case& session, const std::string& path,
                                       const std::string& knownSha256);

/// Whether an error is that another program has changed the case.
bool isChangedElsewhere(const core::Error& error);

}   // namespace angiopose::io
