#pragma once

#include <thread>

namespace angiopose::core {

/// Does both pieces of work at the same time, the first on this thread; neither may read what the other writes.
template <class First, class Second>
void atOnce(const First& first, const Second& second)
{
    if (std::thread::hardware_concurrency() == 1) {
        first();
        second();
        return;
    }
    const std::jthread helper(second);
    first();
}

}   // namespace angiopose::core