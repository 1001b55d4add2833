#pragma once

#include "core/case/case.h"

#include <optional>
#include <string>

namespace angiopose::test {

/// Writes a case with a small tree and image to a folder and returns its path.
std::string writeSmallCase(const std::string& folder);

/// Loads the case at `path` if it is complete; its title contains the number of saves.
std::optional<core::Case> wholeCase(const std::string& path);

/// Title long enough that a kill can interrupt the writing of the file.
std::string titleOf(int number);
int numberOf(const core::Case& session);

/// Runs a job until it is killed or finished, and returns the program's exit code. `ready` is a descriptor that
/// receives a byte when the job starts.
int runJob(const std::string& job, const std::string& folder, int ready);

/// Names the incomplete files among those written by `runJob`; empty if all are complete.
std::string findHalfWritten(const std::string& job, const std::string& folder);

}   // namespace angiopose::test
