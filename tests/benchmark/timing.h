#pragma once

#include <chrono>
#include <ctime>

namespace angiopose::benchmarks {

struct Timing {
    double wall = 0.0;
    double processor = 0.0;
};

template <class Work>
Timing timed(const Work& work)
{
    const auto start = std::chrono::steady_clock::now();
    const std::clock_t used = std::clock();
    work();
    return {std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(),
            static_cast<double>(std::clock() - used) / CLOCKS_PER_SEC};
}

}   // namespace angiopose::benchmarks
