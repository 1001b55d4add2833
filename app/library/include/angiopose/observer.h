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
    std::string stage;   ///< "reading", "search", "refine", …
    double fraction = 0.0;   ///< 0…1, never decreasing
    int view = 0;   ///< which view of the case it is about, counted from 0
    int iteration = 0;
    double medianDistancePx = 0.0;   ///< tree points to their nearest image point
    std::optional<Pose> cameraFromPatient;   ///< best pose so far
};

/// Called on the calling thread, again and again. What it throws ends the work like Stop and comes out of the call.
using Observer = std::function<Verdict(const Progress&)>;

}   // namespace angiopose
