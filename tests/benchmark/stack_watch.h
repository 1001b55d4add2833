#pragma once

#include <csignal>
#include <ctime>
#include <string>
#include <vector>

namespace angiopose::benchmarks {

/// Records the call stack of the calling thread after a given processor time, to identify what made an event handler
/// slow.
class StackWatch {
public:
    /// Only one may exist at a time, on the thread that it watches.
    explicit StackWatch(double afterMs);
    ~StackWatch();
    StackWatch(const StackWatch&) = delete;
    StackWatch& operator=(const StackWatch&) = delete;

    void begin() const;   ///< discards earlier records
    /// Stops watching and returns the named functions on the recorded stack, innermost first; empty if the time limit
    /// was not reached.
    std::vector<std::string> end() const;

private:
    void arm(double ms) const;

    double afterMs_;
    timer_t timer_{};
};

}   // namespace angiopose::benchmarks
