#pragma once

#include "core/support/first_exception.h"
#include "core/support/thread_limit.h"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <thread>
#include <vector>

namespace angiopose::core {

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

}   // namespace angiopose::core