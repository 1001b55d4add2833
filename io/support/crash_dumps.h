#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace angiopose::io {

/// Where this user's programs keep what outlives a session and is no document: `$XDG_STATE_HOME/angiopose`, or below
/// `~/.local/state`. It need not be there.
std::filesystem::path stateFolder();

/// Where dumps of faults lie, one for window and command line.
std::filesystem::path crashFolder();

/// From now on a fault of `program` leaves a dump in the user's `crashFolder` (system/crash_handler.h); of all dumps
/// the newest few are kept. For the start of a program.
void beginCrashDumps(const std::string& program);

/// The dumps that a program left, newest first; of all programs where none is named.
std::vector<std::filesystem::path> crashDumps(const std::string& program = {});

/// A dump to be read: names of functions as they stand in the source.
std::string readableDump(const std::filesystem::path& dump);

}   // namespace angiopose::io
