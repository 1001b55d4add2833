#pragma once

#include "core/support/result.h"

#include <exception>
#include <new>

namespace angiopose::app {

/// Runs `work` and turns whatever a library throws into an error for the user: the only place where a job catches.
template <class T, class Work>
core::Result<T> guarded(const Work& work)
{
    try {
        return work();
    } catch (const std::bad_alloc&) {
        return core::Error{"There is not enough memory for this. Close other programs or use smaller inputs."};
    } catch (const std::exception& problem) {
        return core::Error{std::string("A library gave up: ") + problem.what() + ". Check the inputs."};
    }
}

}   // namespace angiopose::app