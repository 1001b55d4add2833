#pragma once

#include <string>
#include <vector>

namespace angiopose::test {

struct LimitedRun {
    int exitCode = -1;   ///< -1: it did not exit normally
    int signal = 0;   ///< signal that killed it; 0 if it exited
    bool isTimedOut = false;
    double cpuSeconds = 0.0;
    long peakKilobytes = 0;
};

/// Resource limits of a program; 0 means no limit.
struct RunLimits {
    std::size_t addressSpaceBytes = 0;
    unsigned int seconds = 0;   ///< processor time; a program that only waits gets ten times as long
};

/// Runs a program (path and arguments); both output streams go to the file `output`.
LimitedRun runLimited(const std::vector<std::string>& command, const RunLimits& limits,
                      const std::string& output = "/dev/null");

}   // namespace angiopose::test
