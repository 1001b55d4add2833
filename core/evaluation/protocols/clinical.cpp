#include "core/evaluation/protocols/phantoms.h"
#include "core/evaluation/protocols/protocol_rows.h"
#include "core/simulation/simulated_case.h"
#include "core/support/stopwatch.h"
#include "core/tracing/trace_angiogram.h"

namespace core {
namespace {

constexpr int anatomies = 6;
constexpr std::uint64_t seedsPerExperiment = 1000;

struct Setting {
    Condition condition;
    double nonRigidStdMm = 0.0;
};

const std::vector<Setting>& settings()
{
    static const std::vector<Setting> rows{
        {{"nonrigid-0", "synthetic DSA, rigid", false}, 0.0},
        {{"nonrigid-1", "synthetic DSA, deformed by 1 mm", true}, 1.0},
        {{"nonrigid-2", "synthetic DSA, deformed by 2 mm", false}, 2.0},
        {{"nonrigid-3", "synthetic DSA, deformed by 3 mm", false}, 3.0},
    };
    return rows;
}

/// A view whose tracing fails keeps an empty target: every method then fails on it.
Trial makeTrial(const SimulatedCase& view)
{
    Trial trial;
    Stopwatch stopwatch;
    const auto traced = traceAngiogram(view.angiogram.frames.front(), view.angiogram.polarity);
    trial.traceMs = stopwatch.lapMs();
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

TrialMaker prepare(std::size_t condition, std::uint64_t seed)
{
    return [nonRigidStdMm = settings()[condition].nonRigidStdMm, seed](std::uint64_t number) {
        DsaOptions dsa;
        dsa.frameCount = 1;
        dsa.nonRigidStdMm = nonRigidStdMm;
        const std::uint64_t treeSeed = seed * seedsPerExperiment + number % anatomies;
        return makeTrial(simulateView(treeSeed, trialRandom(clinicalNumber, seed, number)(), {}, dsa));
    };
}

}   // namespace

Protocol clinicalProtocol()
{
    return {"clinical",
            "Synthetic angiograms of six trees through the real tracing, start poses as headers give them (ALGORITHMS "
            "4.4).",
            278,
            anatomies,
            Success::RayDistanceWithin2Mm,
            conditionsOf(settings()),
            prepare};
}

}   // namespace core
