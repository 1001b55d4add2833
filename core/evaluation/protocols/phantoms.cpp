#include "core/evaluation/protocols/phantoms.h"

#include "core/evaluation/trial/cramer_rao_bound.h"
#include "core/simulation/degrade_target.h"
#include "core/support/stopwatch.h"
#include "core/tracing/angiogram/trace_angiogram.h"

#include <algorithm>

namespace angiopose::core {
namespace {

constexpr int pointCount = 2000;
constexpr std::uint64_t phantomSeeds = 1000;

/// Returns the branches that have a curve in the target.
VesselTree visibleBranches(const VesselTree& tree, const Centerline2d& target)
{
    VesselTree visible;
    for (const VesselBranch& branch : tree.branches) {
        if (std::any_of(target.curves.begin(), target.curves.end(),
                        [&](const Curve2d& curve) { return curve.id == branch.id; })) {
            visible.branches.push_back(branch);
        }
    }
    return visible;
}

}   // namespace

SharedPhantom::SharedPhantom(Phantom phantom)
    : scene(std::move(phantom)),
      tree(std::make_shared<const VesselTree>(scene.tree)),
      centroid(centroidInPatient(scene.tree))
{
}

Trial SharedPhantom::makeTrial() const
{
    Trial trial;
    trial.input.tree = scene.tree;
    trial.input.target = scene.target;
    trial.input.camera = scene.camera;
    trial.input.initialCameraFromPatient = scene.trueCameraFromPatient;
    trial.tree = tree;
    trial.trueCameraFromPatient = scene.trueCameraFromPatient;
    return trial;
}

Trial SharedPhantom::makeExactTrial() const
{
    Trial trial = makeTrial();
    trial.input.target = scene.exactTarget;
    trial.targetIsExact = true;
    return trial;
}

Phantoms makePhantoms(std::uint64_t seed, int count)
{
    auto phantoms = std::make_shared<std::vector<SharedPhantom>>();
    for (int k = 0; k < count; ++k) {
        phantoms->emplace_back(makePhantom(seed * phantomSeeds + static_cast<std::uint64_t>(k), pointCount));
    }
    return phantoms;
}

CounterRandom trialRandom(std::uint64_t protocolNumber, std::uint64_t seed, std::uint64_t trial)
{
    return CounterRandom(seed).fork(protocolNumber).fork(trial);
}

void degradeTarget(const SharedPhantom& phantom, const CounterRandom& random, Trial& trial)
{
    trial.input.target = addTracingErrors(phantom.scene.exactTarget, phantom.scene.camera, random);
    trial.errorBound =
        cramerRaoBound(*phantom.tree, visibleBranches(*phantom.tree, trial.input.target), phantom.scene.camera,
                       phantom.scene.trueCameraFromPatient, {degradedJitterPx, degradedCorrelationPoints, true});
}

Eigen::Vector3d randomDirection(double length, CounterRandom& random)
{
    const double x = random.normal();
    const double y = random.normal();
    const double z = random.normal();
    return length * Eigen::Vector3d(x, y, z).normalized();
}

Trial makeTracedTrial(const SimulatedCase& view)
{
    Trial trial;
    Stopwatch stopwatch;
    const auto traced = traceAngiogram(view.angiogram.frames.front(), view.angiogram.polarity);
    trial.traceMs = stopwatch.takeLapMs();
    if (traced) {
        trial.input.target = traced.value().centerline;
    }
    trial.input.image = std::make_shared<const ImageF>(view.angiogram.frames.front());
    trial.input.polarity = view.angiogram.polarity;
    trial.input.tree = view.tree;
    trial.input.camera = view.camera;
    trial.input.initialCameraFromPatient = view.initialCameraFromPatient;
    trial.tree = std::make_shared<const VesselTree>(view.tree);
    trial.trueCameraFromPatient = view.trueCameraFromPatient;
    return trial;
}

}   // namespace angiopose::core
