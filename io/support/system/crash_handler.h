#pragma once

#include <string>

namespace angiopose::io {

/// Which program's faults are written down, and where.
struct CrashWriter {
    std::string program;   ///< "angiopose", the beginning of the files' names
    std::string version;
    std::string folder;   ///< made where it is not there
};

/// From now on a fault (SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, std::terminate) leaves a file in the folder before it
/// ends the process by the same signal: version, signal, time, thread and stack with module, offset and, where the
/// module has it, the function. No path, no argument, no text of an exception: nothing of who or what was worked on.
/// For the start of a program; nothing under sanitizers, which do the same.
void writeCrashDumps(const CrashWriter& writer);

}   // namespace angiopose::io
