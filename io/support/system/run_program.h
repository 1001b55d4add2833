#pragma once

#include <string>
#include <vector>

namespace angiopose::io {

/// Describes how another program ended.
struct ProgramExit {
    bool isStarted = false;
    int exitCode = 0;
    int signal = 0;   ///< signal that terminated the program; 0 if none
};

/// Runs a program, given by its path or by a name in the search path, until it ends; its output goes to the streams of
/// this process. Ctrl+C reaches only this process. If `isStopped` returns true, sends SIGTERM to the program and waits
/// for it to end.
ProgramExit runProgram(const std::string& program, std::vector<std::string> arguments, bool (*isStopped)());

}   // namespace angiopose::io
