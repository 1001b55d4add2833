#pragma once

#include "core/case/case.h"

#include <optional>
#include <string>

namespace angiopose::test {

/// A case of a small tree and image in a folder; its path.
std::string writeSmallCase(const std::string& folder);

/// The case at `path` if it is whole; its title says how often it was saved.
std::optional<core::Case> wholeCase(const std::string& path);

/// A title that makes the file large enough to be caught half written.
std::string titleOf(int number);
int numberOf(const core::Case& session);

/// Work that goes on until it is killed, or until it is done: the exit code of the program. `ready` is a descriptor
/// that gets a byte when it begins.
int runJob(const std::string& job, const std::string& folder, int ready);

/// What of the files that `runJob` writes is not whole; empty: everything is.
std::string findHalfWritten(const std::string& job, const std::string& folder);

}   // namespace angiopose::test
