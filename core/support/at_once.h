#pragma once

#include "core/support/first_exception.h"
#include "core/support/thread_limit.h"

#include <thread>

namespace angiopose::core {

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