#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace angiopose::core {

/// Returns the number of threads this process may use at once: the number of processors, or the limit if one is set. It
/// affects only computation times, never results.
int availableThreads();

/// Limits the threads of this process, including those of its libraries, for when several such processes share the
/// machine. Call before any work begins.
void limitThreads(int threads);

/// Passes the first exception thrown in worker threads to the waiting thread.
class FirstException {
public:
    /// Runs `work`, stores any exception it throws, and returns whether there was none.
    template <class Work>
    bool run(const Work& work) noexcept
    {
        try {
            work();
            return true;
        } catch (...) {
            const std::scoped_lock lock(mutex_);
            if (!first_) {
                first_ = std::current_exception();
            }
            return false;
        }
    }

    /// Rethrows the stored exception, if any. Call only after all threads have finished.
    void rethrow() const
    {
        if (first_) {
            std::rethrow_exception(first_);
        }
    }

private:
    std::mutex mutex_;
    std::exception_ptr first_;
};

/// Returns `requested`, or the number of usable threads if `requested` is 0.
inline int threadCount(int requested)
{
    return requested > 0 ? requested : availableThreads();
}

/// Calls `work(i)` once for each i below `count` on `threads` threads, including the calling one. The calling thread
/// also calls `meanwhile(done)` between its work items; if that returns false, the remaining items are skipped. Results
/// that depend only on i and are stored by i are the same for any number of threads. An exception from `work` skips the
/// remaining items and is rethrown to the caller.
template <class Work, class OnProgress>
bool parallelFor(std::size_t count, int threads, const Work& work, const OnProgress& onProgress)
{
    std::atomic<std::size_t> next{0};
    std::atomic<bool> stopped{false};
    FirstException thrown;
    const auto runItem = [&](std::size_t i) {
        if (!thrown.run([&] { work(i); })) {
            stopped = true;
        }
    };
    std::vector<std::jthread> workers;
    for (int t = 1; t < threads; ++t) {
        workers.emplace_back([&] {
            for (std::size_t i = next++; i < count && !stopped; i = next++) {
                runItem(i);
            }
        });
    }
    for (std::size_t i = next++; i < count && !stopped; i = next++) {
        runItem(i);
        const double done = static_cast<double>(i + 1) / static_cast<double>(count);
        if (!stopped && !thrown.run([&] { stopped = !onProgress(done); })) {
            stopped = true;
        }
    }
    workers.clear();   // waits until the other threads have finished their current items
    thrown.rethrow();
    return !stopped;
}

/// Runs both functions in parallel, the first on the calling thread; neither may read data that the other writes. An
/// exception from either is rethrown to the caller after both have finished.
template <class First, class Second>
void runInParallel(const First& first, const Second& second)
{
    if (availableThreads() == 1) {
        first();
        second();
        return;
    }
    FirstException thrown;
    {
        const std::jthread helper([&] { thrown.run(second); });
        thrown.run(first);
    }
    thrown.rethrow();
}

}   // namespace angiopose::core
