#include "core/case/followed_bends.h"

#include <algorithm>

namespace angiopose::core {

const FollowedBend* bendAt(const FollowedBends& bends, const RigidTransform& cameraFromPatient)
{
    const auto found = std::ranges::find_if(
        bends, [&](const FollowedBend& each) { return each.cameraFromPatient.matrix() == cameraFromPatient.matrix(); });
    return found == bends.end() ? nullptr : &*found;
}

}   // namespace angiopose::core
