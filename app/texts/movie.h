#pragma once

#include "app/texts/overlay_image.h"
#include "core/support/observer_decision.h"
#include "core/viewing/cine_clock.h"
#include "core/workflow/track_frames.h"

#include <functional>
#include <string>
#include <vector>

namespace angiopose::app {

/// Content of a movie: the overlay on the frames of a cine run, the poses of a registration as it converges, or the
/// vessels alone during one rotation about the patient's long axis.
enum class MovieContent { Run, Convergence, Turn };

/// Content and speed of a movie.
struct MoviePlan {
    MovieContent content = MovieContent::Run;
    core::FrameRange frames;   ///< frames of the cine run
    core::CineOrder order = core::CineOrder::Loop;
    std::vector<core::TrackedRunFrame> followed;   ///< tracked poses by frame; frames without one use the case's pose
    double framesPerSecond = 15.0;
};

/// Returns the acquisition rate of the cine run, frames per second; 15 if the file does not state one.
double framesPerSecondOf(const core::Angiogram& run);
inline constexpr double convergenceFramesPerSecond = 12.0;   ///< one pose per frame, as in the replay of the window
inline constexpr double rotationFramesPerSecond = 20.0;

/// Number of frames and duration of a movie.
struct MovieLength {
    std::size_t pictures = 0;
    double seconds = 0.0;
};
MovieLength movieLength(const core::Case& session, const MoviePlan& plan);

/// Returns the ratio of height to width of the frames of a movie.
double movieAspect(const core::Case& session, const MoviePlan& plan);

/// Receives the completed fraction; returning Stop ends the writing.
using MovieObserver = std::function<core::ObserverDecision(double fraction)>;

/// Writes an MP4 or GIF movie, depending on the extension. drawOverlay renders each frame at its pose with a constant
/// display range; a caption states the source of the pose and whether it is reliable. No file remains after a Stop.
core::Status writeMovie(const core::Case& session, const core::Centerline2d& target, const OverlayImageOptions& options,
                        const MoviePlan& plan, const std::string& path, const MovieObserver& observe);

}   // namespace angiopose::app
