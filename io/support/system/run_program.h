#pragma once

#include <string>
#include <vector>

namespace angiopose::io {

/// How another program ended.
struct ProgramEnd {
    bool isStarted = false;
    int exitCode = 0;
    int signal = 0;   ///< that ended it; 0: none
};

/// Runs a program, by its path or a name in the search path, to its end; what it says goes where ours goes. Ctrl+C is
/// for us alone: once `isStopped` says so the program is asked to end (SIGTERM), and its end is waited for.
ProgramEnd runProgram(const std::string& program, std::vector<std::string> arguments, bool (*isStopped)());

}   // namespace angiopose::io
