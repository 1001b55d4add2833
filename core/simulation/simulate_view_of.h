#pragma once

#include "core/simulation/grow_tree.h"

namespace angiopose::core {

/// Where a view is taken from, and what its header says of that.
struct ViewGeometryTruth {
    CArm header;
    ProjectionCamera camera;
    RigidTransform trueCameraFromPatient;
    RigidTransform initialCameraFromPatient;
};

/// simulateView of a tree and a place that are there already.
SimulatedCase simulateViewOf(const GrownTree& grown, const ViewGeometryTruth& geometry, std::uint64_t viewSeed,
                             const DsaOptions& dsa);

/// simulateView of a tree that is there already. `extentMm` decides the field of view, as that of a grown tree does.
SimulatedCase simulateViewOf(const GrownTree& grown, double extentMm, std::uint64_t viewSeed,
                             const DsaOptions& dsa = {});

}   // namespace angiopose::core
