#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace angiopose::io {

/// A helper program that executes commands line by line until there are no more. It receives and answers on descriptor
/// 3; its standard output is discarded, and its error messages go to this process's. Ctrl+C reaches only the parent.
/// The destructor kills the worker if it still runs.
class WorkerProcess {
public:
    /// `environment`: "NAME=value", overriding the variables of this process.
    WorkerProcess(const std::string& program, std::vector<std::string> arguments,
                  const std::vector<std::string>& environment);
    WorkerProcess(const WorkerProcess&) = delete;
    WorkerProcess& operator=(const WorkerProcess&) = delete;
    ~WorkerProcess();

    bool isStarted() const { return id_ > 0; }
    int id() const { return id_; }

    /// Sends a line; returns false if the worker no longer runs.
    bool tell(const std::string& line) const;

    enum class Heard { Nothing, Line, End };
    /// Receives the next available line into `line`, without waiting. End: the worker no longer runs.
    Heard hear(std::string& line);

    /// Asks it to stop its current work (SIGTERM).
    void askToStop() const;

    /// Kills it and waits for its end; returns how it ended ("signal 11") if it had already ended on its own.
    std::string end();

    /// Waits until a worker sends something or ends, at most this long; a signal to this process ends the wait.
    static void waitForAny(std::span<const WorkerProcess* const> workers, int milliseconds);

private:
    int id_ = -1;
    int channel_ = -1;
    std::string heard_;   ///< received part of an incomplete line
};

/// The worker's end of the channel.
class WorkerChannel {
public:
    /// Makes this process end when `parent`, which started it, ends. Returns false if the parent has already ended, or
    /// nobody is at the other end of the channel.
    static bool open(int parent);

    /// Receives the next line; returns false at the end, or when a signal arrives and `isStopped` returns true.
    static bool hear(std::string& line, bool (*isStopped)());
    static bool say(const std::string& line);
};

}   // namespace angiopose::io
