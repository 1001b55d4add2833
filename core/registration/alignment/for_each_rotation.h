#pragma once

#include "core/registration/alignment/coarse_search.h"

#include <functional>

namespace angiopose::core {

/// Visits `start` rotated by every tilt and roll within the range, in steps of about `stepDeg`, skipping locked angles.
/// `proceed` receives the completed fraction of the tilts; Stop ends the iteration.
void forEachRotation(const CentroidPose& start, const SearchRange& reach,
                     const std::function<void(const CentroidPose&)>& visit,
                     const std::function<ObserverDecision(double)>& proceed);

}   // namespace angiopose::core
