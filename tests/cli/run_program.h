#pragma once

#include <string>
#include <vector>

namespace angiopose::test {

/// Exit code, output and resource use of a finished program.
struct ProgramOutcome {
    int exitCode = -1;   ///< −1: terminated by a signal
    std::string output;   ///< stdout
    std::string messages;   ///< stderr
    double seconds = 0.0;
    long peakMemoryKiB = 0;
};

/// Runs angiopose-cli with the arguments and waits until it ends. `interruptAfterSeconds` > 0 sends SIGINT after that
/// time.
ProgramOutcome runCli(const std::vector<std::string>& arguments, double interruptAfterSeconds = 0.0);

/// Runs the program at that path in the same way.
ProgramOutcome runProgram(const std::string& path, const std::vector<std::string>& arguments,
                          double interruptAfterSeconds = 0.0);

}   // namespace angiopose::test
