#pragma once

#include "core/geometry/rigid_transform.h"
#include "core/registration/problem/registration_result.h"

namespace angiopose::core {

/// Tracking result of one frame of a run.
struct TrackedFrame {
    RigidTransform cameraFromPatient;
    double score = 0.0;   ///< agreement in both directions, 0…1
    bool searched = false;   ///< the prediction did not fit and its surroundings were searched
    bool isTrustworthy = false;   ///< false: no nearby pose explains the frame, and the pose is the prediction
    StageTimes time;
};

}   // namespace angiopose::core
