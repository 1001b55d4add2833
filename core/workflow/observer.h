#pragma once

#include "core/registration/registration.h"
#include "core/support/observer_decision.h"

#include <cstddef>
#include <functional>
#include <string_view>

namespace angiopose::core {

/// Progress of an operation on a case.
struct WorkReport {
    std::string_view stage;   ///< "tracing", "following", or a stage of the solver: "search", "refine", …
    double fraction = 0.0;   ///< fraction of the whole operation, 0…1, never decreasing
    std::size_t view = 0;   ///< index into Case::views of the current view
    const IterationReport* iteration = nullptr;   ///< report of the solver in that view, valid during the call; or null
};

/// Observer of operations on a case. It is called on the calling thread, several times a second. If it returns Stop,
/// the operation is canceled but keeps useful intermediate results.
using WorkObserver = std::function<ObserverDecision(const WorkReport&)>;

/// Reports the progress of an operation to its observer, for use in the implementation. Converts the progress of each
/// part to a never-decreasing fraction of the whole and records a stop request.
class ProgressReporter {
public:
    explicit ProgressReporter(const WorkObserver& observe) : observe_(observe) {}
    ProgressReporter(const ProgressReporter&) = delete;
    ProgressReporter& operator=(const ProgressReporter&) = delete;

    /// Starts a part: subsequent reports are about `view`, with progress from `first` to `last` of the whole.
    void enter(double first, double last, std::size_t view);

    /// Reports `fraction`, the progress within the part, and returns the observer's decision.
    ObserverDecision report(std::string_view stage, double fraction, const IterationReport* iteration = nullptr);
    bool isStopped() const { return isStopped_; }

private:
    const WorkObserver& observe_;
    double first_ = 0.0;
    double last_ = 1.0;
    double reported_ = 0.0;
    std::size_t view_ = 0;
    bool isStopped_ = false;
};

}   // namespace angiopose::core
