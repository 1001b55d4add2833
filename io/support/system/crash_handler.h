#pragma once

#include <string>

namespace angiopose::io {

/// The program whose crashes are recorded, and the folder for the dumps.
struct CrashDumpSettings {
    std::string program;   ///< prefix of the file names, for example "angiopose"
    std::string version;
    std::string folder;   ///< created if it does not exist
};

/// Makes a crash (SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, std::terminate) write a file to the folder before the same
/// signal terminates the process. The file contains version, signal, time, thread, and the stack with module, offset
/// and, if known, function. It contains no paths, arguments or exception messages, and therefore nothing about the user
/// or the data. Must be called at program start; does nothing under sanitizers, which report crashes themselves.
void installCrashHandler(const CrashDumpSettings& writer);

}   // namespace angiopose::io
