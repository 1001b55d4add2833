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

/// Does the same as simulateView for an existing tree and geometry.
SimulatedCase simulateViewOf(const GrownTree& grown, const TrueViewGeometry& geometry, std::uint64_t viewSeed,
                             const DsaOptions& dsa);

/// Does the same as simulateView for an existing tree. `extentMm` determines the field of view, like the extent of a
/// generated tree.
SimulatedCase simulateViewOf(const GrownTree& grown, double extentMm, std::uint64_t viewSeed,
                             const DsaOptions& dsa = {});

}   // namespace angiopose::core
