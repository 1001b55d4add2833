#pragma once

#include "core/simulation/grow_tree.h"

namespace angiopose::core {

/// True geometry of a view, and the geometry in its header.
struct TrueViewGeometry {
    CArm header;
    ProjectionCamera camera;
    RigidTransform trueCameraFromPatient;
    RigidTransform initialCameraFromPatient;
};

/// Simulates a view like simulateView, but of an existing tree with a given geometry.
SimulatedCase simulateViewOf(const GrownTree& grown, const TrueViewGeometry& geometry, std::uint64_t viewSeed,
                             const DsaOptions& dsa);

/// Simulates a view like simulateView, but of an existing tree. `extentMm` determines the field of view, like the
/// extent of a generated tree.
SimulatedCase simulateViewOf(const GrownTree& grown, double extentMm, std::uint64_t viewSeed,
                             const DsaOptions& dsa = {});

}   // namespace angiopose::core
