#pragma once

#include "angiopose/geometry.h"

#include <functional>
#include <optional>
#include <string>

namespace angiopose {

/// Decision of an observer: continue or stop the long-running work.
enum class Verdict { Continue, Stop };

/// Progress of long-running work. The last three members are set only during a registration.
struct Progress {
    /// "reading" (of files, including tracing where reading requires it); for a registration "search", "refine",
    /// "settle" and further stages of the method; for traceVessels and traceMask the steps of tracing
    std::string stage;
    double fraction = 0.0;   ///< 0…1, never decreasing
    int view = 0;   ///< index of the view in the case, from 0
    int iteration = 0;
    double medianDistancePx = 0.0;   ///< median distance from tree points to their closest image points
    std::optional<Pose> cameraFromPatient;   ///< best pose so far
};

/// Called repeatedly on the calling thread, except for work that completes at once, such as reading a small file. An
/// exception thrown by the observer ends the work as Stop does and propagates to the caller.
using Observer = std::function<Verdict(const Progress&)>;

}   // namespace angiopose
