#pragma once

#include "app/texts/movie.h"

namespace angiopose::app {

/// One frame of a movie.
struct MovieStep {
    core::Case session;   ///< with its frame and pose; images are shared
    std::optional<core::Message> words;   ///< caption of the frame
    double ms = 0.0;
};

/// Reason why the case has no such movie; empty if it has.
std::optional<core::Message> findProblem(const core::Case& session, const MoviePlan& plan);

/// Sequence of a movie's frames: constructed once, then queried frame by frame. The plan must be valid.
class MovieSteps {
public:
    MovieSteps(const core::Case& session, const MoviePlan& plan, VesselShape shape);

    std::size_t count() const;
    MovieStep at(std::size_t index) const;

private:
    MovieStep frameStep(std::size_t index) const;
    MovieStep iterationStep(std::size_t index) const;

    core::Case case_;
    MoviePlan plan_;
    std::optional<core::Message> turned_;   ///< of a rotation: note on the non-rigid part
};

}   // namespace angiopose::app
