#pragma once

#include "tests/benchmark/deformed_cases.h"

namespace angiopose::benchmarks {

/// The pose of the first view that brings the undeformed tree nearest to the true positions of its points: in the image
/// for one view, in 3-D for several. No rigid registration can be better.
core::RigidTransform bestRigidPose(const DeformedCase& deformedCase);

/// The pose of the first view that is nearest in 3-D: the definition of a rigid pose for deformed vessels.
core::RigidTransform nearestPoseInSpace(const DeformedCase& deformedCase);

}   // namespace angiopose::benchmarks
