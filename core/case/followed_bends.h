#pragma once

#include "core/registration/deformable/deform_vessels.h"

#include <memory>
#include <optional>
#include <vector>

namespace angiopose::core {

/// How the vessels are bent where a frame of a run has them.
struct FollowedBend {
    RigidTransform cameraFromPatient;   ///< the frame's pose, beside which they are bent
    std::shared_ptr<const DeformableResult> bent;
    std::optional<int> foundInFrame{};   ///< another one: this does not show the vessels well enough
};

/// Of the frames of a run, as following found them (workflow/follow_frames).
using FollowedBends = std::vector<FollowedBend>;

/// The one at a pose; null where there is none.
const FollowedBend* bendAt(const FollowedBends& bends, const RigidTransform& cameraFromPatient);

}   // namespace angiopose::core
