#pragma once

#include <string>
#include <vector>

namespace angiopose::io {

/// How another program ended.
struct ProgramEnd {
    bool isStarted = false;
    int exitCode = 0;
    int signal = 0;   ///< signal that ended it; 0: none
};

/// Runs a program, given by its path or a name in the search path, until it ends; its output goes to this process's
/// streams. Ctrl+C reaches only this process: when `isStopped` returns true, sends the program SIGTERM and waits for
/// its end.
ProgramEnd runProgram(const std::string& program, std::vector<std::string> arguments, bool (*isStopped)());

}   // namespace angiopose::io
