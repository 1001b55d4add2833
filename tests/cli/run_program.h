#pragma once

#include <string>
#include <vector>

namespace angiopose::test {

/// What a finished program left behind.
struct ProgramOutcome {
    int exitCode = -1;   ///< −1: ended by a signal
    std::string output;   ///< stdout
    std::string messages;   ///< stderr
    double seconds = 0.0;
    long peakMemoryKiB = 0;
};

/// Runs angiopose-cli with the arguments and waits for its end. `interruptAfterSeconds` > 0 sends SIGINT then.
ProgramOutcome runCli(const std::vector<std::string>& arguments, double interruptAfterSeconds = 0.0);

/// Likewise the program at that path.
ProgramOutcome runProgram(const std::string& path, const std::vector<std::string>& arguments,
                          double interruptAfterSeconds = 0.0);

}   // namespace angiopose::test