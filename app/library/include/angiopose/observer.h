#pragma once

#include "angiopose/geometry.h"

#include <functional>
#include <optional>
#include <string>

namespace angiopose {

/// Decision of an observer: long-running work continues or stops.
enum class Verdict { Continue, Stop };

/// Progress of long-running work. The last three members are set only during a registration.
struct Progress {
    /// "reading" (files, and tracing if reading traces); for a registration "search", "refine", "settle" and the stages
    /// that the method adds; for traceVessels and traceMask the steps of tracing
    std::string stage;
    double fraction = 0.0;   ///< 0…1, never decreasing
    int view = 0;   ///< index of the view in the case, from 0
    int iteration = 0;
    double medianDistancePx = 0.0;   ///< from tree points to their closest image points
    std::optional<Pose> cameraFromPatient;   ///< best pose so far
};

/// Called repeatedly on the calling thread, but not for work that completes at once, such as reading a small file. An
/// exception thrown by the observer ends the work like Stop and propagates to the caller.
using Observer = std::function<Verdict(const Progress&)>;

}   // namespace angiopose
