#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace angiopose::io {

/// Helper program and the read end of its output pipe. Its standard input is empty; its error output is discarded.
/// Ctrl+C reaches only the parent. The destructor kills the helper if it is still running.
class ChildProcess {
public:
    ChildProcess(const std::string& program, std::vector<std::string> arguments);
    ChildProcess(const ChildProcess&) = delete;
    ChildProcess& operator=(const ChildProcess&) = delete;
    ~ChildProcess();

    bool isStarted() const { return id_ > 0; }

    enum class ReadStatus { Nothing, Bytes, End };
    struct Output {
        ReadStatus what = ReadStatus::Nothing;
        std::size_t size = 0;   ///< number of bytes read
    };
    /// Reads the helper's output, waiting for at most `milliseconds`; if negative, waits until data arrive. A signal to
    /// the parent ends the wait.
    Output readOutput(std::span<char> buffer, int milliseconds) const;

    enum class EndReason { Normal, TimedOut, Fault };   ///< `TimedOut` includes termination by another process
    EndReason waitForExit();

private:
    int id_ = -1;
    int output_ = -1;
};

}   // namespace angiopose::io
