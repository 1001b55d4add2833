#include "core/evaluation/protocols/phantoms.h"
#include "core/evaluation/protocols/protocol_rows.h"
#include "core/simulation/simulated_case.h"

#include <numbers>

namespace angiopose::core {
namespace {

constexpr int simulationAnatomies = 10;

enum class Pivot { Centroid, Source, SourceByNorm };   ///< OBJ, CAM, and CAM with fixed norm (ALGORITHMS §4.2)
/// Exact projections of the tree's points, the same curves resampled, or curves with simulated tracing errors.
enum class Target { Exact, Resampled, Degraded };

struct SimulationSetting {
    Condition condition;
    Pivot pivot = Pivot::Centroid;
    double rotationStdDeg = 0.0;   ///< per axis; for `SourceByNorm`, the angle of the whole rotation
    double translationStdMm = 0.0;   ///< per axis; for `SourceByNorm`, the length of the whole shift
    Target target = Target::Resampled;
    double depthStdMm = 0.0;   ///< standard deviation of an additional shift in depth
};

const std::vector<SimulationSetting>& simulationSettings()
{
    using enum Target;
    static const std::vector<SimulationSetting> rows{
        {{"cam-2-5", "2°/5 mm about the source (CAM)", true}, Pivot::Source, 2, 5, Resampled},
        {{"obj-2-5", "2°/5 mm about the centroid (OBJ)", true}, Pivot::Centroid, 2, 5, Resampled},
        {{"degraded-cam-2-5", "CAM 2°/5 mm, degraded target", true}, Pivot::Source, 2, 5, Degraded},
        {{"degraded-obj-2-5", "OBJ 2°/5 mm, degraded target", true}, Pivot::Centroid, 2, 5, Degraded},
        {{"exact-cam-2-5", "CAM 2°/5 mm, the tree's own points as target", true}, Pivot::Source, 2, 5, Exact},
        {{"exact-cam-norm-2-5", "2° and 5 mm about the source in a random direction, the tree's own points", true},
         Pivot::SourceByNorm,
         2,
         5,
         Exact},
        {{"exact-obj-2-5", "OBJ 2°/5 mm, the tree's own points as target", false}, Pivot::Centroid, 2, 5, Exact},
        {{"cam-norm-2-5", "2° and 5 mm about the source in a random direction", false},
         Pivot::SourceByNorm,
         2,
         5,
         Resampled},
        {{"cam-3-8", "CAM 3°/8 mm", false}, Pivot::Source, 3, 8, Resampled},
        {{"cam-5-10", "CAM 5°/10 mm", false}, Pivot::Source, 5, 10, Resampled},
        {{"degraded-cam-5-10", "CAM 5°/10 mm, degraded target", false}, Pivot::Source, 5, 10, Degraded},
        {{"obj-5-10", "OBJ 5°/10 mm", false}, Pivot::Centroid, 5, 10, Resampled},
        {{"obj-10-20", "OBJ 10°/20 mm", false}, Pivot::Centroid, 10, 20, Resampled},
        {{"obj-15-30", "OBJ 15°/30 mm", false}, Pivot::Centroid, 15, 30, Resampled},
        {{"depth-20", "OBJ 2°/5 mm, depth ±20 mm", false}, Pivot::Centroid, 2, 5, Resampled, 20},
        {{"depth-60", "OBJ 2°/5 mm, depth ±60 mm", false}, Pivot::Centroid, 2, 5, Resampled, 60},
    };
    return rows;
}

RigidTransform perturbed(const RigidTransform& truth, const SharedPhantom& phantom, const SimulationSetting& setting,
                         CounterRandom& random)
{
    const double deg = setting.rotationStdDeg;
    const double mm = setting.translationStdMm;
    switch (setting.pivot) {
        case Pivot::Centroid:
            return perturbAboutCentroid(truth, phantom.centroid, deg, mm, random);
        case Pivot::Source:
            return perturbAboutSource(truth, deg, mm, random);
        case Pivot::SourceByNorm:
            break;
    }
    Vector6d twist;
    twist.head<3>() = randomDirection(deg * std::numbers::pi / 180.0, random);
    twist.tail<3>() = randomDirection(mm, random);
    return expSe3(twist) * truth;
}

RigidTransform initialPose(const SharedPhantom& phantom, const SimulationSetting& setting, CounterRandom random)
{
    RigidTransform start = perturbed(phantom.scene.trueCameraFromPatient, phantom, setting, random);
    start.translation.z() += setting.depthStdMm * random.normal();
    return start;
}

TrialMaker prepareSimulation(std::size_t condition, std::uint64_t seed)
{
    return [phantoms = makePhantoms(seed, simulationAnatomies), setting = simulationSettings()[condition],
            seed](std::uint64_t number) {
        const CounterRandom random = trialRandom(simulationNumber, seed, number);
        const SharedPhantom& phantom = (*phantoms)[number % simulationAnatomies];
        Trial trial = setting.target == Target::Exact ? phantom.makeExactTrial() : phantom.makeTrial();
        if (setting.target == Target::Degraded) {
            degradeTarget(phantom, random.fork(1), trial);
        }
        trial.input.initialCameraFromPatient = initialPose(phantom, setting, random.fork(0));
        return trial;
    };
}

}   // namespace

Protocol simulationProtocol()
{
    return {"simulation",
            "Generated trees, Gaussian initial poses, ideal or degraded targets (ALGORITHMS 4.2, 4.4).",
            1000,
            simulationAnatomies,
            SuccessCriterion::ProjectionWithin5Px,
            conditionsOf(simulationSettings()),
            prepareSimulation};
}

}   // namespace angiopose::core
