#pragma once

#include "core/registration/alignment/coarse_search.h"

#include <functional>

namespace angiopose::core {

/// Visits `start` turned by every tilt and roll within reach, in steps of about `stepDeg`, locked ones left out.
/// `proceed` hears the share of the tilts that is done; its Stop ends the visits.
void forEachTurn(const CentroidPose& start, const SearchReach& reach,
                 const std::function<void(const CentroidPose&)>& visit, const std::function<Verdict(double)>& proceed);

}   // namespace angiopose::core
