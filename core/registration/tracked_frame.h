#pragma once

#include "core/geometry/rigid_transform.h"
#include "core/registration/problem/registration_result.h"

namespace angiopose::core {

/// One frame of a run.
struct TrackedFrame {
    RigidTransform cameraFromPatient;
    double score = 0.0;   ///< agreement both ways, 0…1
    bool searched = false;   ///< the prediction did not fit and the surroundings were searched
    bool isTrustworthy = false;   ///< false: nothing near explains the frame, the pose is the prediction
    StageTimes time;
};

}   // namespace angiopose::core
