#pragma once

#include "core/geometry/rigid_transform.h"
#include "core/registration/problem/registration_result.h"

namespace angiopose::core {

/// Tracking result for one frame of a cine run.
struct TrackedFrame {
    RigidTransform cameraFromPatient;
    double score = 0.0;   ///< agreement in both directions, 0…1
    bool isFromSearch = false;   ///< whether poses around the prediction were searched because it did not fit
    bool isTrustworthy = false;   ///< whether a nearby pose explains the frame; otherwise the pose is the prediction
    StageTimes time;
};

}   // namespace angiopose::core
