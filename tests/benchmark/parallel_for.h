#pragma once

#include <atomic>
#include <cstddef>
#include <thread>
#include <vector>

namespace benchmarks {

/// Calls `work(i)` once for each i below `count`, on `threads` threads. Results that depend on i alone and are stored
/// by i come out the same for any number of threads.
template <class Work>
void parallelFor(std::size_t count, int threads, const Work& work)
{
    std::atomic<std::size_t> next{0};
    std::vector<std::jthread> pool;
    pool.reserve(static_cast<std::size_t>(threads));
    for (int t = 0; t < threads; ++t) {
        pool.emplace_back([&] {
            for (std::size_t i = next++; i < count; i = next++) {
                work(i);
            }
        });
    }
}

}   // namespace benchmarks
