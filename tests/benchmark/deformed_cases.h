#pragma once

#include "core/geometry/projection_camera.h"
#include "core/geometry/rigid_transform.h"
#include "core/vessel/centerline2d.h"
#include "tests/benchmark/true_motions.h"

#include <vector>

namespace angiopose::benchmarks {

/// One view of a bent tree.
struct DeformedView {
    core::ProjectionCamera camera;
    core::RigidTransform truth;   ///< cameraFromPatient
    core::RigidTransform nominal;   ///< what headers say: in every view by the same error
    core::Centerline2d target;   ///< with jitter, whole pixels, pieces in no order, foreign curves
};

/// A tree, how it was bent, and what views of it show.
struct DeformedCase {
    core::VesselTree tree;
    core::VesselTree deformed;   ///< the same points
    std::vector<bool> isMissing;   ///< per branch: not filled
    std::vector<DeformedView> views;
};

/// About the origin, where the views of a case look at.
core::VesselTree centerd(core::VesselTree tree);

/// Makes a case by a generator of its own: nothing of it is shared with the program's simulator. A fifth of the
/// branches that end freely is not filled, one foreign curve for every five branches is; the nominal pose is off by 1°
/// and 3 mm (1-σ per axis). Views after the first are turned about the body's axis by `turnsDeg`.
DeformedCase makeDeformedCase(const core::VesselTree& tree, const TrueMotion& motion,
                              const std::vector<double>& turnsDeg, core::CounterRandom random);

/// One frame of a run: how the vessels are bent and lie there, and what is seen of them.
struct DeformedFrame {
    core::VesselTree deformed;
    DeformedView view;
};

/// A run in which breath moves the vessels of a case up and down by `breathMm` and bends them to and fro: by the
/// motion, and by another one of half its size that comes a quarter of a period later. Frame 0 is the first.
std::vector<DeformedFrame> makeDeformedRun(const DeformedCase& first, const TrueMotion& motion, double breathMm,
                                           double framesPerBreath, std::size_t frames, core::CounterRandom random);

}   // namespace angiopose::benchmarks
