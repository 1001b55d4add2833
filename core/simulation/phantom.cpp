#include "core/simulation/phantom.h"

#include "core/geometry/c_arm.h"
#include "core/simulation/simulated_case.h"

namespace angiopose::core {
namespace {

constexpr double depthMm = 800.0;
constexpr double focalLengthPx = 1877.0;   // at 512 × 512 px; larger images cover the same field of view
constexpr int referenceSizePx = 512;

double lengthMm(const VesselTree& tree)
{
    double sum = 0.0;
    for (const VesselBranch& branch : tree.branches) {
        sum += branch.lengthMm();
    }
    return sum;
}

RigidTransform clinicalPose(const VesselTree& tree, CounterRandom random)
{
    CArm cArm;
    cArm.sourceToIsocenterMm.value = depthMm;
    cArm.primaryAngleDeg.value = random.uniform(-45.0, 45.0);
    cArm.secondaryAngleDeg.value = random.uniform(-30.0, 30.0);
    return cameraFromPatient(cArm, centroidInPatient(tree)).value();
}

ProjectionCamera cameraOfSize(int imageSizePx)
{
    const double f = focalLengthPx * imageSizePx / referenceSizePx;
    const double center = 0.5 * (imageSizePx - 1);
    return {-f, f, center, center, imageSizePx, imageSizePx};
}

}   // namespace

Phantom makePhantom(std::uint64_t seed, int pointCount, int imageSizePx)
{
    Phantom phantom;
    const VesselTree tree = simulateTree(seed);
    phantom.tree = resampled(tree, lengthMm(tree) / (pointCount - static_cast<double>(tree.branches.size())));
    phantom.camera = cameraOfSize(imageSizePx);
    phantom.trueCameraFromPatient = clinicalPose(phantom.tree, CounterRandom(seed).fork(1));
    phantom.target = projectCurves(phantom.tree, phantom.camera, phantom.trueCameraFromPatient);
    phantom.exactTarget = projectTree(phantom.tree, phantom.camera, phantom.trueCameraFromPatient);
    return phantom;
}

}   // namespace angiopose::core
