#pragma once

#include "angiopose/error.h"
#include "angiopose/observer.h"
#include "core/registration/registration.h"
#include "core/support/message.h"
#include "core/support/result.h"
#include "core/support/verdict.h"
#include "core/tracing/volume/trace_vessels.h"
#include "core/workflow/observer.h"
#include "io/support/read_observer.h"

#include <exception>
#include <string>
#include <string_view>
#include <vector>

namespace angiopose::library {

/// The messages of the layers below as the library gives them away.
Message toPublic(const core::Message& message);
std::vector<Message> toPublic(const core::Messages& messages);

/// Throws what the layers below say.
[[noreturn]] void raise(const core::Error& error);

/// The value of work that was not observed; else throws why there is none.
template <class T>
T valueOf(core::Result<T> outcome)
{
    if (!outcome) {
        raise(outcome.error());
    }
    return std::move(outcome).value();
}

inline void check(const core::Status& status)
{
    if (!status) {
        raise(status.error());
    }
}

/// Tells a caller's observer what observed work reports. What the observer throws stops the work, and comes out of
/// `take`: the layers below know no exceptions of others.
class Relay {
public:
    explicit Relay(const Observer& observe) : observe_(observe) {}
    Relay(const Relay&) = delete;
    Relay& operator=(const Relay&) = delete;

    core::IterationObserver iterations();
    core::WorkObserver working();
    io::ReadObserver reading(std::string_view stage);
    core::TracingObserver tracing();

    /// The value of the work; else throws what the observer threw, or why there is none.
    template <class T>
    T take(core::Result<T> outcome) const
    {
        if (thrown_) {
            std::rethrow_exception(thrown_);
        }
        return valueOf(std::move(outcome));
    }

private:
    core::Verdict tell(const Progress& progress);

    const Observer& observe_;
    bool isStopped_ = false;
    std::exception_ptr thrown_;
};

}   // namespace angiopose::library
