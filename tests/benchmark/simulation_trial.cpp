#include "tests/benchmark/simulation_trial.h"

#include "core/geometry/c_arm.h"
#include "core/simulation/simulated_case.h"
#include "tests/benchmark/degraded_target.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdlib>
#include <limits>

namespace benchmarks {
namespace {

constexpr double depthMm = 800.0;
constexpr std::array<const char*, 4> presetNames{"seed_sum", "seed_mean", "seed_metric", "seed_noprior"};

double lengthMm(const core::VesselTree& tree)
{
    double sum = 0.0;
    for (const core::VesselBranch& branch : tree.branches) {
        sum += branch.lengthMm();
    }
    return sum;
}

core::RigidTransform clinicalPose(const core::VesselTree& tree, core::CounterRandom random)
{
    core::CArm cArm;
    cArm.sourceToPatientMm.value = depthMm;
    cArm.primaryAngleDeg.value = random.uniform(-45.0, 45.0);
    cArm.secondaryAngleDeg.value = random.uniform(-30.0, 30.0);
    return core::cameraFromPatient(cArm, core::centroidInPatient(tree)).value();
}

}   // namespace

Phantom makePhantom(std::uint64_t seed, int pointCount)
{
    Phantom phantom;
    const core::VesselTree tree = core::simulateTree(seed);
    phantom.tree = core::resampled(tree, lengthMm(tree) / (pointCount - static_cast<double>(tree.branches.size())));
    phantom.camera = {-1877.0, 1877.0, 255.5, 255.5, 512, 512};
    phantom.trueCameraFromPatient = clinicalPose(phantom.tree, core::CounterRandom(seed).fork(1));
    phantom.exactTarget = core::projectTree(phantom.tree, phantom.camera, phantom.trueCameraFromPatient);
    return phantom;
}

core::RegistrationInput makeTrialInput(const Phantom& phantom, const TrialPlan& plan, std::uint64_t run)
{
    const core::CounterRandom random = core::CounterRandom(plan.seed).fork(run);
    core::CounterRandom poseRandom = random.fork(0);
    core::RegistrationInput input;
    input.tree = phantom.tree;
    input.camera = phantom.camera;
    input.target = plan.target == Target::Exact ? phantom.exactTarget
                                                : degraded(phantom.exactTarget, phantom.camera, random.fork(1));
    input.initialCameraFromPatient =
        plan.noise == PoseNoise::AboutCentroid
            ? core::perturbedAboutCentroid(phantom.trueCameraFromPatient, core::centroidInPatient(phantom.tree),
                                           plan.rotationStdDeg, plan.translationStdMm, poseRandom)
            : core::perturbedAboutSource(phantom.trueCameraFromPatient, plan.rotationStdDeg, plan.translationStdMm,
                                         poseRandom);
    return input;
}

Contestant contestantOf(const std::string& name, Target target)
{
    const std::size_t colon = name.find(':');
    Contestant contestant{name, {}};
    contestant.options.method = name.substr(0, colon);
    if (target == Target::Exact && contestant.options.method != "angiopose") {
        contestant.options.resample = 0;   // point to point, the exact partners are what can be matched exactly
    }
    const auto infos = core::methodInfos();
    if (std::none_of(infos.begin(), infos.end(),
                     [&](const core::MethodInfo& info) { return info.id == contestant.options.method; })) {
        return {};
    }
    if (colon != std::string::npos) {
        const auto preset = std::find(presetNames.begin(), presetNames.end(), name.substr(colon + 1));
        if (preset == presetNames.end()) {
            return {};
        }
        contestant.options.preset = static_cast<double>(preset - presetNames.begin());
    }
    return contestant;
}

bool setOption(core::RegistrationOptions& options, const std::string& assignment)
{
    const std::size_t equals = assignment.find('=');
    for (const core::OptionField& field : core::optionFields()) {
        if (equals != std::string::npos && field.key == assignment.substr(0, equals)) {
            field.write(options, std::strtod(assignment.c_str() + equals + 1, nullptr));
            return true;
        }
    }
    return false;
}

TrialOutcome runTrial(const Phantom& phantom, const core::RegistrationInput& input, const Contestant& contestant)
{
    const auto begin = std::chrono::steady_clock::now();
    const core::Result<core::RegistrationResult> result = core::registerVessels(input, contestant.options);
    TrialOutcome outcome;
    outcome.timeMs = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
    outcome.failed = !result;
    const core::PosePair poses{result ? result.value().cameraFromPatient : input.initialCameraFromPatient,
                               phantom.trueCameraFromPatient};
    outcome.trustworthy = result && result.value().trustworthy;
    outcome.projection = core::projectionError(phantom.tree, phantom.camera, poses);
    outcome.pose = core::poseError(core::centroidInPatient(phantom.tree), poses);
    outcome.start = core::poseError(core::centroidInPatient(phantom.tree),
                                    {input.initialCameraFromPatient, phantom.trueCameraFromPatient});
    return outcome;
}

}   // namespace benchmarks
