#pragma once

#include <csignal>
#include <ctime>
#include <string>
#include <vector>

namespace angiopose::benchmarks {

/// Notes where the calling thread was after so much processor time, to name what made an event handler slow.
class StackWatch {
public:
    /// One at a time, on the thread that it watches.
    explicit StackWatch(double afterMs);
    ~StackWatch();
    StackWatch(const StackWatch&) = delete;
    StackWatch& operator=(const StackWatch&) = delete;

    void begin() const;   ///< what was noted before is forgotten
    /// Stops watching; named functions on the stack at the time, innermost first. Empty when it did not take so long.
    std::vector<std::string> end() const;

private:
    void arm(double ms) const;

    double afterMs_;
    timer_t timer_{};
};

}   // namespace angiopose::benchmarks