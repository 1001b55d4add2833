#pragma once

#include "core/geometry/projection_camera.h"
#include "core/geometry/rigid_transform.h"
#include "core/vessel/centerline2d.h"
#include "tests/benchmark/true_motions.h"

#include <vector>

namespace angiopose::benchmarks {

struct DeformedView {
    core::ProjectionCamera camera;
    core::RigidTransform truth;   ///< cameraFromPatient
    core::RigidTransform nominal;   ///< pose from the headers, with the same error in every view
    core::Centerline2d target;   ///< with jitter, rounded to pixels, pieces in random order, foreign curves
};

/// A tree, its true deformation, and its views.
struct DeformedCase {
    core::VesselTree tree;
    core::VesselTree deformed;   ///< same points as the original
    std::vector<bool> isMissing;   ///< per branch: unopacified
    std::vector<DeformedView> views;
};

/// The tree shifted to the origin, the center of the views of a case.
core::VesselTree centered(core::VesselTree tree);

/// Generates a case independently of the program's simulator. A fifth of the branches with a free end is unopacified,
/// and there is one foreign curve for every five branches; the nominal pose is off by 1° and 3 mm (1-σ per axis). Views
/// after the first are rotated about the body's axis by `turnsDeg`.
DeformedCase makeDeformedCase(const core::VesselTree& tree, const TrueMotion& motion,
                              const std::vector<double>& turnsDeg, core::CounterRandom random);

/// One frame of a run: the deformation and pose of the vessels, and their visible part.
struct DeformedFrame {
    core::VesselTree deformed;
    DeformedView view;
};

/// Generates a run in which breathing moves the vessels of a case up and down by `breathMm` and deforms them back and
/// forth: by the motion, and by another one of half its size with a delay of a quarter period. Frame 0 is the first.
std::vector<DeformedFrame> makeDeformedRun(const DeformedCase& first, const TrueMotion& motion, double breathMm,
                                           double framesPerBreath, std::size_t frames, core::CounterRandom random);

}   // namespace angiopose::benchmarks
