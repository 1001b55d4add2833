#pragma once

#include "core/support/observer_decision.h"
#include "core/support/result.h"
#include "io/messages/messages.h"

#include <functional>
#include <string>

namespace angiopose::io {

/// Called several times per second while a large input is read. Receives the completed fraction (0…1, never
/// decreasing). Returning Stop cancels reading and discards what was read.
using ReadObserver = std::function<core::ObserverDecision(double fraction)>;

inline bool isStopRequested(const ReadObserver& observe, double fraction)
{
    return observe && observe(fraction) == core::ObserverDecision::Stop;
}

/// Returns the outcome of a canceled read.
inline core::Cancellation readingCanceled(const std::string& path)
{
    return {messages::readingStopped().about(path)};
}

/// Returns an observer that maps progress from 0…1 to the range `first` to `last` and passes it to `observe`.
inline ReadObserver progressPart(const ReadObserver& observe, double first, double last)
{
    if (!observe) {
        return {};
    }
    return [observe, first, last](double fraction) { return observe(first + fraction * (last - first)); };
}

}   // namespace angiopose::io
