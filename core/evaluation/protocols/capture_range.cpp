#include "core/evaluation/protocols/phantoms.h"
#include "core/evaluation/protocols/protocol_rows.h"
#include "core/evaluation/trial/projection_error.h"
#include "core/geometry/angle_units.h"
#include "core/support/format_number.h"

#include <numbers>
#include <vector>

namespace angiopose::core {
namespace {

constexpr int captureAnatomies = 6;
constexpr double rotationStdDeg = 2.0;   // rotation of one unit of displacement, whose shift is `shiftStdMm`
constexpr double shiftStdMm = 5.0;

struct CaptureSetting {
    Condition condition;
    bool isDegraded = false;
    double fromMm = 0.0;
    double toMm = 0.0;
};

/// Returns the upper edges of the bins of initial mTRE, mm: 1, 2, … 20, then 25, 30, … 150 (ALGORITHMS §4.5).
std::vector<double> captureBinEdgesMm()
{
    std::vector<double> edges;
    for (int mm = 1; mm <= 150; mm += mm < 20 ? 1 : 5) {
        edges.push_back(mm);
    }
    return edges;
}

std::vector<CaptureSetting> makeCaptureSettings()
{
    std::vector<CaptureSetting> rows;
    for (const bool isDegraded : {false, true}) {
        double from = 0.0;
        for (const double to : captureBinEdgesMm()) {
            const std::string range = plainText(from) + "-" + plainText(to);
            rows.push_back({{(isDegraded ? "degraded-" : "clean-") + range,
                             "start " + plainText(from) + "–" + plainText(to) + " mm, " +
                                 (isDegraded ? "degraded target" : "resampled curves"),
                             true},
                            isDegraded,
                            from,
                            to});
            from = to;
        }
    }
    return rows;
}

const std::vector<CaptureSetting>& captureSettings()
{
    static const std::vector<CaptureSetting> rows = makeCaptureSettings();
    return rows;
}

/// Displacement about the centroid (OBJ) along a fixed direction, scaled by a factor.
struct Displacement {
    Eigen::Vector3d omega;
    Eigen::Vector3d shift;

    RigidTransform applied(const RigidTransform& truth, const Eigen::Vector3d& centroid, double scale) const
    {
        const Eigen::Matrix3d rotation = expSo3(scale * omega) * truth.rotation;
        return {rotation, truth * centroid + scale * shift - rotation * centroid};
    }
};

Displacement drawDisplacement(CounterRandom& random)
{
    Displacement unit;
    for (int k = 0; k < 3; ++k) {
        unit.omega[k] = rotationStdDeg * radiansPerDegree * random.normal();
    }
    for (int k = 0; k < 3; ++k) {
        unit.shift[k] = shiftStdMm * random.normal();
    }
    return unit;
}

/// Returns the initial pose with an mTRE of `requestedMm` along the drawn displacement. Bisection works because the
/// mTRE grows with the displacement.
RigidTransform initialPoseWithError(double requestedMm, const SharedPhantom& phantom, const Displacement& unit)
{
    const RigidTransform& truth = phantom.scene.trueCameraFromPatient;
    const std::vector<Eigen::Vector3d> targets = targetsOf(*phantom.tree);
    double low = 0.0;
    double high = std::numbers::pi / unit.omega.norm();   // rotation by 180°
    for (int halving = 0; halving < 50; ++halving) {
        const double scale = 0.5 * (low + high);
        const RigidTransform pose = unit.applied(truth, phantom.centroid, scale);
        (targetError(targets, {pose, truth}).mtreMm < requestedMm ? low : high) = scale;
    }
    return unit.applied(truth, phantom.centroid, high);
}

TrialMaker prepareCapture(std::size_t condition, std::uint64_t seed)
{
    return [phantoms = makePhantoms(seed, captureAnatomies), setting = captureSettings()[condition],
            seed](std::uint64_t number) {
        const CounterRandom random = trialRandom(captureRangeNumber, seed, number);
        const SharedPhantom& phantom = (*phantoms)[number % captureAnatomies];
        Trial trial = phantom.makeTrial();
        if (setting.isDegraded) {
            degradeTarget(phantom, random.fork(1), trial);
        }
        CounterRandom start = random.fork(0);
        const double requestedMm = start.uniform(setting.fromMm, setting.toMm);
        trial.input.initialCameraFromPatient = initialPoseWithError(requestedMm, phantom, drawDisplacement(start));
        return trial;
    };
}

}   // namespace

Protocol captureRangeProtocol()
{
    return {"capture-range",
            "Initial poses in bins of their mean target error: determines the capture range (ALGORITHMS 4.5).",
            60,
            captureAnatomies,
            SuccessCriterion::RayDistanceWithin2Mm,
            conditionsOf(captureSettings()),
            prepareCapture};
}

}   // namespace angiopose::core
