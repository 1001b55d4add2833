#pragma once

#include <string>
#include <vector>

namespace angiopose::test {

/// How a program ended.
struct LimitedRun {
    int exitCode = -1;   ///< -1: it did not exit by itself
    int signal = 0;   ///< what killed it; 0 when it exited
    bool isTimedOut = false;
    double cpuSeconds = 0.0;
    long peakKilobytes = 0;
};

/// What a program may use; 0: no limit.
struct RunLimits {
    std::size_t addressSpaceBytes = 0;
    unsigned int seconds = 0;   ///< of processor time; a program that only waits gets ten times as long
};

/// Runs a program (path and arguments); both its streams go to the file `output`.
LimitedRun runLimited(const std::vector<std::string>& command, const RunLimits& limits,
                      const std::string& output = "/dev/null");

}   // namespace angiopose::test
