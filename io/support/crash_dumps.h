#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace angiopose::io {

/// Returns the folder for the user's persistent state other than documents: `$XDG_STATE_HOME/angiopose`, or below
/// `~/.local/state`. The folder may not exist.
std::filesystem::path stateFolder();

/// Returns the folder of crash dumps, shared by the GUI and the command line.
std::filesystem::path crashFolder();

/// Makes crashes of `program` write a dump to the user's `crashFolder` (system/crash_handler.h), and deletes all but
/// the newest few dumps. Must be called at program start.
void enableCrashDumps(const std::string& program);

/// Returns the dumps of a program, newest first; those of all programs if `program` is empty.
std::vector<std::filesystem::path> crashDumps(const std::string& program = {});

/// Returns the text of a dump with demangled function names.
std::string demangleDump(const std::filesystem::path& dump);

}   // namespace angiopose::io
