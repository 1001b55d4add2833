#pragma once

#include "core/registration/deformable/deform_vessels.h"

#include <memory>
#include <utility>
#include <vector>

namespace angiopose::core {

/// How the vessels are bent in the frames of a run, as following found them (workflow/follow_frames), by the pose that
/// each of these frames has: cameraFromPatient.
using FollowedBends = std::vector<std::pair<RigidTransform, std::shared_ptr<const DeformableResult>>>;

}   // namespace angiopose::core
