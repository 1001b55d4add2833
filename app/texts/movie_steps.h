#pragma once

#include "app/texts/movie.h"

namespace angiopose::app {

/// One picture of a movie.
struct MovieStep {
    core::Case session;   ///< with its frame and pose; images are shared
    std::optional<core::Message> words;   ///< what this picture is
    double ms = 0.0;
};

/// Why there is no such movie of the case; nothing where there is.
std::optional<core::Message> findProblem(const core::Case& session, const MoviePlan& plan);

/// How the pictures of a case follow each other: made once, asked for picture by picture. The plan makes sense.
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
    std::optional<core::Message> turned_;   ///< of a turn: what of it is not rigid
};

}   // namespace angiopose::app
