#pragma once

#include "core/registration/alignment/coarse_search.h"

#include <functional>

namespace angiopose::core {

/// Visits `start` rotated by every tilt and roll within the range, in steps of about `reach.stepDeg`; locked angles are
/// skipped. `proceed` receives the completed fraction of the tilts; if it returns Stop, the iteration ends.
void forEachRotation(const CentroidPose& start, const SearchRange& range,
                     const std::function<void(const CentroidPose&)>& visit,
                     const std::function<ObserverDecision(double)>& observe);

}   // namespace angiopose::core
