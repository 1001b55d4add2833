#pragma once

#include <chrono>
#include <ctime>

namespace angiopose::core {

/// Measures the wall time since construction or the last reading.
class Stopwatch {
public:
    double takeLapMs()
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

/// Measures the CPU time of the constructing thread, which depends less on other programs than the wall time does.
class ThreadStopwatch {
public:
    double elapsedMs() const { return nowMs() - startMs_; }

private:
    static double nowMs()
    {
        std::timespec now{};
        clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
        return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
    }
    double startMs_ = nowMs();
};

}   // namespace angiopose::core
