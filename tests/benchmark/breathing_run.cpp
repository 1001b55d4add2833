#include "tests/benchmark/breathing_run.h"

#include "core/evaluation/trial/projection_error.h"
#include "core/simulation/simulated_case.h"

#include <cmath>
#include <numbers>

namespace angiopose::benchmarks {
namespace {

constexpr double framesPerBreath = 60.0;
constexpr double jitterPx = 0.5;

core::RigidTransform breathed(const core::Trial& trial, std::size_t frame)
{
    const double phase = 0.5 - 0.5 * std::cos(2.0 * std::numbers::pi * static_cast<double>(frame) / framesPerBreath);
    core::Vector6d motion;
    motion << 0.05 * phase, 0.0, 0.01 * phase, 1.0 * phase, 10.0 * phase, -2.0 * phase;
    const Eigen::Vector3d centroid = core::centroidInPatient(*trial.tree);
    return core::cameraFromPatient(core::moved(core::aboutCentroid(trial.trueCameraFromPatient, centroid), motion),
                                   centroid);
}

}   // namespace

double BreathingRun::errorPx(const core::RigidTransform& pose, std::size_t frame) const
{
    return core::projectionError(*tree, first.camera, {pose, truth[frame]}).meanPx;
}

BreathingRun breathingRun(const core::Trial& trial, std::size_t frames)
{
    core::RegistrationInput input = trial.input;
    input.initialCameraFromPatient = trial.trueCameraFromPatient;
    BreathingRun run{core::makeProblem(input, {}).value(), {}, {}, trial.tree};
    core::CounterRandom random(11);
    for (std::size_t frame = 1; frame <= frames; ++frame) {
        run.truth.push_back(breathed(trial, frame));
        run.targets.push_back(core::projectCurves(*trial.tree, trial.input.camera, run.truth.back()));
        for (core::Curve2d& curve : run.targets.back().curves) {
            for (Eigen::Vector2d& point : curve.pointsPx) {
                point += jitterPx * Eigen::Vector2d(random.normal(), random.normal());
            }
        }
    }
    return run;
}

}   // namespace angiopose::benchmarks
