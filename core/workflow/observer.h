#pragma once

#include "core/registration/registration.h"
#include "core/support/verdict.h"

#include <cstddef>
#include <functional>
#include <string_view>

namespace angiopose::core {

/// How far work on a case is.
struct WorkReport {
    std::string_view stage;   ///< "tracing", "following", or of the solver: "search", "refine", …
    double fraction = 0.0;   ///< of the whole work, 0…1, never decreasing
    std::size_t view = 0;   ///< place in Case::views of what is worked on
    const IterationReport* iteration = nullptr;   ///< of a solver in that view, for as long as the call lasts; or null
};

/// The one observer of everything that is done with a case. Called on the calling thread, several times a second; its
/// Stop ends the work, and what was found so far is kept where it is worth something.
using WorkObserver = std::function<Verdict(const WorkReport&)>;

/// The way through one piece of work, for who carries it out: tells the observer each part as a part of the whole, so
/// that progress never falls, and remembers that it was told to stop.
class Course {
public:
    explicit Course(const WorkObserver& observe) : observe_(observe) {}
    Course(const Course&) = delete;
    Course& operator=(const Course&) = delete;

    /// What is told from now on is about `view`, and goes from `first` to `last` of the whole.
    void enter(double first, double last, std::size_t view);

    /// `fraction`: of the part.
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
