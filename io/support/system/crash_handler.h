#pragma once

#include <string>

namespace angiopose::io {

/// The program whose faults are recorded, and the folder for the dumps.
struct CrashWriter {
    std::string program;   ///< "angiopose", the prefix of the file names
    std::string version;
    std::string folder;   ///< created if it does not exist
};

/// Makes a fault (SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, std::terminate) write a file to the folder before the same
/// signal ends the process: version, signal, time, thread and stack with module, offset and, if the module has it, the
/// function. Contains no path, argument or exception text, hence nothing about the user or the data. To be called at
/// program start; does nothing under sanitizers, which report faults themselves.
void writeCrashDumps(const CrashWriter& writer);

}   // namespace angiopose::io
