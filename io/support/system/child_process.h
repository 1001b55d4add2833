#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace angiopose::io {

/// A program that runs beside ours and the end of the pipe that it writes to; it reads nothing, and its messages are
/// dropped. Ctrl+C is for us alone. Killed, if it still runs, with the object.
class ChildProcess {
public:
    ChildProcess(const std::string& program, std::vector<std::string> arguments);
    ChildProcess(const ChildProcess&) = delete;
    ChildProcess& operator=(const ChildProcess&) = delete;
    ~ChildProcess();

    bool isStarted() const { return id_ > 0; }

    enum class Heard { Nothing, Bytes, End };
    struct Output {
        Heard what = Heard::Nothing;
        std::size_t size = 0;   ///< of the bytes
    };
    /// What it writes within that time; below 0: waits until something comes. A signal to us ends the waiting.
    Output listen(std::span<char> place, int milliseconds) const;

    enum class Ending { ItsOwn, OutOfTime, Fault };   ///< out of time: also killed from outside
    Ending waitForEnd();

private:
    int id_ = -1;
    int output_ = -1;
};

}   // namespace angiopose::io
