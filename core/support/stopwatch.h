#pragma once

#include <chrono>

namespace core {

/// Wall time since it was made or last read.
class Stopwatch {
public:
    double lapMs()
    {
        const auto now = Clock::now();
        const double elapsed = std::chrono::duration<double, std::milli>(now - start_).count();
        start_ = now;
        return elapsed;
    }

private:
    using Clock = std::chrono::steady_clock;
    Clock::time_point start_ = Clock::now();
};

}   // namespace core
