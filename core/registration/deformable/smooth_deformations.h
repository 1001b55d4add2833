#pragma once

#include "core/registration/deformable/deform_vessels.h"

#include <cstddef>
#include <memory>
#include <vector>

namespace angiopose::core {

/// Frame in which deformed vessels were found.
struct DeformationInTime {
    int frame = 0;
    RigidTransform rigidCameraFromPatient;   ///< rigid pose of that frame
    std::shared_ptr<const DeformableResult> deformed;
};

/// Smooths deformations over time (ALGORITHMS §11.6): relative to the rigid pose of its frame, every vessel point
/// performs a random walk from frame to frame, with a step variance estimated from the frames; each frame observes it
/// with its own covariance (Rauch, Tung and Striebel 1965). The covariances remain those of the single frames, because
/// errors are correlated between neighboring frames.
std::vector<DeformationInTime> smoothInTime(const VesselTree& tree, const std::vector<DeformationInTime>& deformations);

}   // namespace angiopose::core
