#pragma once

#include "core/registration/registration.h"
#include "core/support/verdict.h"

#include <cstddef>
#include <functional>
#include <string_view>

namespace angiopose::core {

/// Progress of work on a case.
struct WorkReport {
    std::string_view stage;   ///< "tracing", "following", or a stage of the solver: "search", "refine", …
    double fraction = 0.0;   ///< fraction of the whole work, 0…1, never decreasing
    std::size_t view = 0;   ///< index into Case::views of the current view
    const IterationReport* iteration = nullptr;   ///< report of the solver in that view, valid during the call; or null
};

/// Observer of all work on a case. Called on the calling thread, several times a second; returning Stop ends the work,
/// and useful intermediate results are kept.
using WorkObserver = std::function<Verdict(const WorkReport&)>;

/// Progress of one task, for its implementation: reports each part to the observer as a fraction of the whole, never
/// decreasing, and records a stop request.
class Course {
public:
    explicit Course(const WorkObserver& observe) : observe_(observe) {}
    Course(const Course&) = delete;
    Course& operator=(const Course&) = delete;

    /// Starts a part: subsequent reports are about `view` and range from `first` to `last` of the whole.
    void enter(double first, double last, std::size_t view);

    /// `fraction`: progress within the part.
    Verdict tell(std::string_view stage, double fraction, const IterationReport* iteration = nullptr);
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
