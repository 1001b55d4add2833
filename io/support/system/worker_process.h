#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace angiopose::io {

/// Helper program that executes commands line by line until there are no more. The worker receives commands and replies
/// on file descriptor 3; its standard output is discarded, and its error output goes to that of this process. Ctrl+C
/// reaches only the parent. The destructor kills the worker if it is still running.
class WorkerProcess {
public:
    /// `environment` lists "NAME=value" entries that override variables of this process.
    WorkerProcess(const std::string& program, std::vector<std::string> arguments,
                  const std::vector<std::string>& environment);
    WorkerProcess(const WorkerProcess&) = delete;
    WorkerProcess& operator=(const WorkerProcess&) = delete;
    ~WorkerProcess();

    bool isStarted() const { return id_ > 0; }
    int id() const { return id_; }

    /// Sends a line; returns false if the worker is no longer running.
    bool sendLine(const std::string& line) const;

    enum class ReadStatus { Nothing, Line, End };
    /// Receives the next available line into `line` without waiting. Returns End if the worker is no longer running.
    ReadStatus receiveLine(std::string& line);

    /// Requests the worker to cancel its current work (SIGTERM).
    void requestStop() const;

    /// Kills the worker and waits for it to end. Returns the cause if it had already ended on its own ("signal 11").
    std::string end();

    /// Waits until a worker sends something or ends, at most this long; a signal to this process ends the wait.
    static void waitForAny(std::span<const WorkerProcess* const> workers, int milliseconds);

private:
    int id_ = -1;
    int channel_ = -1;
    std::string partialLine_;   ///< start of a line that has not arrived completely
};

/// The worker's end of the channel to its parent.
class WorkerChannel {
public:
    /// Makes this process end when `parent`, which started it, ends. Returns false if the parent has already ended or
    /// the other end of the channel is closed.
    static bool open(int parent);

    /// Receives the next line; returns false at the end, or when a signal arrives and `isStopped` returns true.
    static bool receiveLine(std::string& line, bool (*isStopped)());
    static bool sendLine(const std::string& line);
};

}   // namespace angiopose::io
