#pragma once

#include "angiopose/error.h"
#include "angiopose/observer.h"
#include "core/registration/registration.h"
#include "core/support/message.h"
#include "core/support/observer_decision.h"
#include "core/support/result.h"
#include "core/tracing/volume/trace_vessels.h"
#include "core/workflow/observer.h"
#include "io/support/read_observer.h"

#include <exception>
#include <string>
#include <string_view>
#include <vector>

namespace angiopose::library {

/// Converts a message of the lower layers to the public type.
Message toPublic(const core::Message& message);
std::vector<Message> toPublic(const core::Messages& messages);

/// Throws an error of the lower layers as an exception.
[[noreturn]] void throwError(const core::Error& error);

/// Returns the value of work that ran without an observer, or throws its error.
template <class T>
T valueOf(core::Result<T> outcome)
{
    if (!outcome) {
        throwError(outcome.error());
    }
    return std::move(outcome).value();
}

inline void check(const core::Status& status)
{
    if (!status) {
        throwError(status.error());
    }
}

/// Forwards the progress of observed work to the caller's observer. The lower layers do not handle the caller's
/// exceptions, so that an exception of the observer stops the work and `take` rethrows it.
class ObserverAdapter {
public:
    explicit ObserverAdapter(const Observer& observe) : observe_(observe) {}
    ObserverAdapter(const ObserverAdapter&) = delete;
    ObserverAdapter& operator=(const ObserverAdapter&) = delete;

    core::IterationObserver iterations();
    core::WorkObserver working();
    io::ReadObserver reading(std::string_view stage);
    core::TracingObserver tracing();

    /// Returns the value of the work; otherwise rethrows the observer's exception or throws the error of the work.
    template <class T>
    T resultOf(core::Result<T> outcome) const
    {
        if (exception_) {
            std::rethrow_exception(exception_);
        }
        return valueOf(std::move(outcome));
    }

private:
    core::ObserverDecision notify(const Progress& progress);

    const Observer& observe_;
    bool isStopped_ = false;
    std::exception_ptr exception_;
};

}   // namespace angiopose::library
