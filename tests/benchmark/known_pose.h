#pragma once

#include "tests/benchmark/deformed_cases.h"

namespace angiopose::benchmarks {

/// The pose of the first view that lays the unbent tree nearest to where its points truly are: of one view in its
/// image, of several in space. What no rigid registration can beat.
core::RigidTransform bestRigidPose(const DeformedCase& deformedCase);

/// Likewise of the first view, nearest in space: what a rigid pose of bent vessels means.
core::RigidTransform nearestPoseInSpace(const DeformedCase& deformedCase);

}   // namespace angiopose::benchmarks
