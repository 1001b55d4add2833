#pragma once

#include <exception>
#include <mutex>

namespace angiopose::core {

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

}   // namespace angiopose::core
