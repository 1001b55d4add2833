#pragma once

#include "angiopose/geometry.h"

#include <functional>
#include <optional>
#include <string>

namespace angiopose {

/// What an observer of long work wants next.
enum class Verdict { Continue, Stop };

/// How far long work is. The last three are told while a registration runs.
struct Progress {
    /// "reading" (files, and tracing where reading traces); of a registration "search", "refine", "settle" and what
    /// the method adds; of traceVessels and traceMask the steps of tracing.
    std::string stage;
    double fraction = 0.0;   ///< 0…1, never decreasing
    int view = 0;   ///< which view of the case it is about, counted from 0
    int iteration = 0;
    double medianDistancePx = 0.0;   ///< tree points to their nearest image point
    std::optional<Pose> cameraFromPatient;   ///< best pose so far
};

/// Called on the calling thread, again and again; never where work is done at once, such as reading a small file. What
/// it throws ends the work like Stop and comes out of the call.
using Observer = std::function<Verdict(const Progress&)>;

}   // namespace angiopose
