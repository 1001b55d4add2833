#pragma once

#include "core/support/result.h"
#include "core/support/verdict.h"
#include "io/messages/says.h"

#include <functional>
#include <string>

namespace angiopose::io {

/// Called several times a second while a large input is read, with the fraction done (0…1, never decreasing).
/// Its Stop ends the reading; what was read is dropped.
using ReadObserver = std::function<core::Verdict(double fraction)>;

inline bool isStopRequested(const ReadObserver& observe, double fraction)
{
    return observe && observe(fraction) == core::Verdict::Stop;
}

/// The outcome of a reading that was stopped.
inline core::Stopped stoppedReading(const std::string& path)
{
    return {says::readingStopped().about(path)};
}

/// The same observer for a part of the work that goes from `first` to `last`.
inline ReadObserver partOf(const ReadObserver& observe, double first, double last)
{
    if (!observe) {
        return {};
    }
    return [observe, first, last](double fraction) { return observe(first + fraction * (last - first)); };
}

}   // namespace angiopose::io