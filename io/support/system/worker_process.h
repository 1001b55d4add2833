#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace angiopose::io {

/// A program that runs beside ours and does what it is told, line by line, until it is told nothing more. It hears and
/// answers on descriptor 3; its own output is dropped, its messages go where ours go. Ctrl+C is for us alone. Killed,
/// if it still runs, with the object.
class WorkerProcess {
public:
    /// `environment`: "NAME=value", over what this process has.
    WorkerProcess(const std::string& program, std::vector<std::string> arguments,
                  const std::vector<std::string>& environment);
    WorkerProcess(const WorkerProcess&) = delete;
    WorkerProcess& operator=(const WorkerProcess&) = delete;
    ~WorkerProcess();

    bool isStarted() const { return id_ > 0; }
    int id() const { return id_; }

    /// False where it is not there any more.
    bool tell(const std::string& line) const;

    enum class Heard { Nothing, Line, End };
    /// What it has said by now, one line a time, without waiting; `line` is it. End: it is there no more.
    Heard hear(std::string& line);

    /// Asks it to end what it does (SIGTERM).
    void askToStop() const;

    /// Kills it and waits for its end: in words how that came ("signal 11"), where it had ended by itself before.
    std::string end();

    /// Waits until one of them says something or ends, at most so long; a signal to us ends the waiting.
    static void waitForAny(std::span<const WorkerProcess* const> workers, int milliseconds);

private:
    int id_ = -1;
    int channel_ = -1;
    std::string heard_;   ///< less than a line
};

/// The worker's side of it.
class WorkerChannel {
public:
    /// Makes this process one that ends when the one that started it, `parent`, does. False where that is gone already,
    /// or nobody is at the other end.
    static bool open(int parent);

    /// The next line that it is told; false at the end, or when a signal came and `isStopped` says that it is meant.
    static bool hear(std::string& line, bool (*isStopped)());
    static bool say(const std::string& line);
};

}   // namespace angiopose::io
