#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace angiopose::core {

/// How many threads the work of this process may use at once: as many as the processor has, or fewer where that was
/// limited. Changes times only, never numbers.
int usableThreads();

/// For a process that shares the machine with others of its kind; also for the libraries of this layer. Before any work
/// begins.
void limitThreads(int threads);

/// Carries what work on other threads throws to the thread that waits for them: of several exceptions the first.
class FirstException {
public:
    /// Whether the work came to its end.
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

    /// Only once all threads have ended.
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

/// `asked`, or as many threads as may be used when it is 0.
inline int threadCount(int asked)
{
    return asked > 0 ? asked : usableThreads();
}

/// Calls `work(i)` once for each i below `count`, on `threads` threads, this one among them; `meanwhile(done)` is
/// called on this one between its pieces of work, and its false leaves the rest undone. Results that depend on i alone
/// and are stored by i come out the same for any number of threads. What work throws ends the rest and reaches the
/// caller.
template <class Work, class Meanwhile>
bool parallelFor(std::size_t count, int threads, const Work& work, const Meanwhile& meanwhile)
{
    std::atomic<std::size_t> next{0};
    std::atomic<bool> stopped{false};
    FirstException thrown;
    const auto doPiece = [&](std::size_t i) {
        if (!thrown.run([&] { work(i); })) {
            stopped = true;
        }
    };
    std::vector<std::jthread> helpers;
    for (int t = 1; t < threads; ++t) {
        helpers.emplace_back([&] {
            for (std::size_t i = next++; i < count && !stopped; i = next++) {
                doPiece(i);
            }
        });
    }
    for (std::size_t i = next++; i < count && !stopped; i = next++) {
        doPiece(i);
        const double done = static_cast<double>(i + 1) / static_cast<double>(count);
        if (!stopped && !thrown.run([&] { stopped = !meanwhile(done); })) {
            stopped = true;
        }
    }
    helpers.clear();   // waits for their last piece
    thrown.rethrow();
    return !stopped;
}

/// Does both pieces of work at the same time, the first on this thread; neither may read what the other writes. What
/// either throws reaches the caller once both have ended.
template <class First, class Second>
void atOnce(const First& first, const Second& second)
{
    if (usableThreads() == 1) {
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
