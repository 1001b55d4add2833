#pragma once

#include "app/messages/messages.h"
#include "core/support/result.h"

#include <exception>
#include <new>

namespace angiopose::app {

/// Runs `work` and converts exceptions from libraries to an error for the user. No other code in the jobs catches
/// exceptions.
template <class T, class Work>
core::Result<T> guarded(const Work& work)
{
    try {
        return work();
    } catch (const std::bad_alloc&) {
        return core::Error(messages::notEnoughMemory());
    } catch (const std::exception& problem) {
        return core::Error(messages::libraryGaveUp(problem.what()));
    }
}

}   // namespace angiopose::app
