#pragma once

#include "app/texts/overlay_picture.h"
#include "core/support/verdict.h"
#include "core/viewing/cine_clock.h"
#include "core/workflow/follow_frames.h"

#include <functional>
#include <string>
#include <vector>

namespace angiopose::app {

/// Content of a movie: the overlay through the frames of a cine run, the poses of a registration as it converges, or
/// the vessels alone in one rotation about the patient's long axis.
enum class MovieContent { Run, Convergence, Turn };

/// Content and speed of a movie.
struct MoviePlan {
    MovieContent content = MovieContent::Run;
    core::FrameRange frames;   ///< frames of the cine run
    core::CineOrder order = core::CineOrder::Loop;
    std::vector<core::FollowedFrame> followed;   ///< poses per frame; frames without one use the case's pose
    double framesPerSecond = 15.0;
};

/// Acquisition rate of the cine run, frames per second; 15 if the file does not state it.
double framesPerSecondOf(const core::Angiogram& run);
inline constexpr double convergencePerSecond = 12.0;   ///< same as the replay in the window
inline constexpr double turnPerSecond = 20.0;

/// Number of frames and duration of a movie.
struct MovieLength {
    std::size_t pictures = 0;
    double seconds = 0.0;
};
MovieLength lengthOf(const core::Case& session, const MoviePlan& plan);

/// Ratio of height to width of the movie's frames.
double aspectOf(const core::Case& session, const MoviePlan& plan);

/// Receives the completed fraction; returning Stop ends the writing.
using MovieObserver = std::function<core::Verdict(double fraction)>;

/// Writes MP4 or GIF, by the extension. drawOverlay renders each frame from its frame number and pose with a constant
/// display range; the caption names the source of the pose and whether it is reliable. After a Stop no file is left.
core::Status writeMovie(const core::Case& session, const core::Centerline2d& target,
                        const OverlayPictureOptions& options, const MoviePlan& plan, const std::string& path,
                        const MovieObserver& observe);

}   // namespace angiopose::app
