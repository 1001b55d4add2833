#pragma once

#include "core/registration/deformable/deform_vessels.h"

#include <cstddef>
#include <memory>
#include <vector>

namespace angiopose::core {

/// A frame in which bent vessels were found.
struct DeformationInTime {
    int frame = 0;
    RigidTransform rigidCameraFromPatient;   ///< that frame's
    std::shared_ptr<const DeformableResult> deformed;
};

/// The same bends, smooth in time (ALGORITHMS §11.6): beside the rigid pose of its frame every point of the vessels
/// walks at random from frame to frame, as far as the frames themselves tell, and each frame saw it with its own
/// covariance (Rauch, Tung and Striebel 1965). Covariances stay those of the single frames: what is off in one of them,
/// is off in its neighbours likewise.
std::vector<DeformationInTime> smoothInTime(const VesselTree& tree, const std::vector<DeformationInTime>& deformations);

}   // namespace angiopose::core
