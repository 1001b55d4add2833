#include "core/workflow/observer.h"

#include <algorithm>

namespace angiopose::core {

void ProgressReporter::enter(double first, double last, std::size_t view)
{
    first_ = first;
    last_ = last;
    view_ = view;
}

ObserverDecision ProgressReporter::report(std::string_view stage, double fraction, const IterationReport* iteration)
{
    reported_ = std::max(reported_, std::clamp(first_ + fraction * (last_ - first_), 0.0, 1.0));
    if (!isStopped_ && observe_) {
        isStopped_ = observe_({stage, reported_, view_, iteration}) == ObserverDecision::Stop;
    }
    return isStopped_ ? ObserverDecision::Stop : ObserverDecision::Continue;
}

}   // namespace angiopose::core
