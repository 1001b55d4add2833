#pragma once

#include "core/evaluation/projection_error.h"
#include "core/registration/registration.h"

#include <cstdint>
#include <string>
#include <vector>

namespace benchmarks {

enum class PoseNoise { AboutCentroid, AboutSource };   ///< OBJ and CAM of ALGORITHMS §4.2
enum class Target { Exact, Degraded };

/// One true pose of one generated tree.
struct Phantom {
    core::VesselTree tree;
    core::ProjectionCamera camera;   ///< f = 1877 px, 512×512
    core::RigidTransform trueCameraFromPatient;   ///< centroid 800 mm from the source, clinical angles
    core::Centerline2d exactTarget;
};

/// The tree of this seed with about `pointCount` points.
Phantom makePhantom(std::uint64_t seed, int pointCount);

/// What is done `runs` times.
struct TrialPlan {
    PoseNoise noise = PoseNoise::AboutCentroid;
    double rotationStdDeg = 2.0;
    double translationStdMm = 5.0;
    Target target = Target::Exact;
    std::uint64_t seed = 1;
};

/// The input of run number `run`; the same for every method.
core::RegistrationInput makeTrialInput(const Phantom& phantom, const TrialPlan& plan, std::uint64_t run);

/// A method to be tried, as named on the command line: "angiopose", "dynaweight:seed_noprior", ….
struct Contestant {
    std::string label;
    core::RegistrationOptions options;
};

/// Default options, but the published solvers take exact targets as they are, without resampling.
/// Fails (empty label) when method or preset is unknown.
Contestant contestantOf(const std::string& name, Target target);

/// Changes one option by the key it has in files, e.g. "searchRadiusMm=100"; false when there is no such option.
bool setOption(core::RegistrationOptions& options, const std::string& assignment);

struct TrialOutcome {
    bool failed = false;   ///< no result at all
    bool trustworthy = false;
    core::PoseError start;   ///< of the start pose
    core::ProjectionError projection;
    core::PoseError pose;
    double timeMs = 0.0;
};

TrialOutcome runTrial(const Phantom& phantom, const core::RegistrationInput& input, const Contestant& contestant);

}   // namespace benchmarks
