#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace angiopose::io {

/// Returns the folder for this user's persistent program state other than documents: `$XDG_STATE_HOME/angiopose`, or
/// below `~/.local/state`. It need not exist.
std::filesystem::path stateFolder();

/// Returns the folder of crash dumps, shared by window and command line.
std::filesystem::path crashFolder();

/// Makes crashes of `program` write a dump to the user's `crashFolder` (system/crash_handler.h), and keeps only the
/// newest few dumps. To be called at program start.
void beginCrashDumps(const std::string& program);

/// Returns the dumps of a program, newest first; of all programs if none is named.
std::vector<std::filesystem::path> crashDumps(const std::string& program = {});

/// Returns the text of a dump with demangled function names.
std::string readableDump(const std::filesystem::path& dump);

}   // namespace angiopose::io
