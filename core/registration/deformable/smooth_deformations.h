#pragma once

#include "core/registration/deformable/deform_vessels.h"

#include <cstddef>
#include <memory>
#include <vector>

namespace angiopose::core {

/// Deformation found in one frame.
struct TimedDeformation {
    int frame = 0;
    RigidTransform rigidCameraFromPatient;   ///< rigid pose of that frame
    std::shared_ptr<const DeformableResult> deformed;
};

/// Smooths deformations over time (Rauch, Tung and Striebel 1965; ALGORITHMS §11.6). Relative to the rigid pose of each
/// frame, every vessel point performs a random walk, with a step variance estimated from the frames; each frame
/// observes the point with its own covariance. The covariances remain those of the single frames, because errors are
/// correlated between neighboring frames.
std::vector<TimedDeformation> smoothOverTime(const VesselTree& tree, const std::vector<TimedDeformation>& deformations);

}   // namespace angiopose::core
