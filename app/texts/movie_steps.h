#pragma once

#include "app/texts/movie.h"

namespace angiopose::app {

struct MovieStep {
    core::Case session;   ///< case with the frame and the pose of this step; images are shared
    std::optional<core::Message> words;   ///< caption of the frame
    double durationMs = 0.0;
};

/// Returns the reason why this movie of the case is not possible; nullopt if it is possible.
std::optional<core::Message> findProblem(const core::Case& session, const MoviePlan& plan);

/// Sequence of a movie's frames; constructed once, then queried frame by frame. The plan must be valid.
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
    std::optional<core::Message> rotationNote_;   ///< for a rotation, a note on the shape of the vessels
};

}   // namespace angiopose::app
