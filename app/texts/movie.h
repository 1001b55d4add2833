#pragma once

#include "app/texts/overlay_picture.h"
#include "core/support/verdict.h"
#include "core/viewing/cine_clock.h"
#include "core/workflow/follow_frames.h"

#include <functional>
#include <string>
#include <vector>

namespace angiopose::app {

/// The overlay through the frames of a run, the poses that a registration went through, or the vessels alone that turn
/// once about the patient's long axis.
enum class MovieContent { Run, Convergence, Turn };

/// What a movie shows, and how fast.
struct MoviePlan {
    MovieContent content = MovieContent::Run;
    core::FrameRange frames;   ///< of a run
    core::CineOrder order = core::CineOrder::Loop;
    std::vector<core::FollowedFrame> followed;   ///< poses of frames; where there are none, the case's holds
    double framesPerSecond = 15.0;
};

/// How many frames a second the shown run was taken; 15 where it does not say.
double framesPerSecondOf(const core::Angiogram& run);
inline constexpr double convergencePerSecond = 12.0;   ///< as the replay in the window
inline constexpr double turnPerSecond = 20.0;

/// Pictures of a movie and how long it lasts.
struct MovieLength {
    std::size_t pictures = 0;
    double seconds = 0.0;
};
MovieLength lengthOf(const core::Case& session, const MoviePlan& plan);

/// Height by width of its pictures.
double aspectOf(const core::Case& session, const MoviePlan& plan);

/// Told the part that is done; its Stop ends the writing.
using MovieObserver = std::function<core::Verdict(double fraction)>;

/// Writes MP4 or GIF by the end of the path. Each picture is what drawOverlay makes of its frame and pose, in grey
/// values that stay the same; it says whose pose it shows and whether that is trusted. After a Stop nothing is left.
core::Status writeMovie(const core::Case& session, const core::Centerline2d& target,
                        const OverlayPictureOptions& options, const MoviePlan& plan, const std::string& path,
                        const MovieObserver& observe);

}   // namespace angiopose::app
