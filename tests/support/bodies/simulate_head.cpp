#include "core/simulation/paint_torso.h"
#include "tests/support/bodies/head_anatomy.h"
#include "tests/support/bodies/simulate_body.h"

namespace angiopose::core {
namespace {

constexpr double brainHu = 38.0;
constexpr double sinusShare = 0.5;   // share of the arteries' contrast

}   // namespace

BodyScan simulateHead(std::uint64_t seed, const BodyScanOptions& options)
{
    CounterRandom random(seed ^ 0x4EADULL);
    const Eigen::Vector3d extentMm(170.0, 200.0, 170.0);
    const Eigen::Vector3d spacingMm = options.spacingMm;
    const VolumeGeometry geometry =
        gridAroundOrigin(extentMm.cwiseQuotient(spacingMm).array().ceil().cast<int>(), spacingMm);
    ScanGrid grid(geometry, static_cast<float>(airHu));
    ScanPainter painter(grid);
    paintHead(painter, {});
    BodyScan scan;
    scan.arteries = headArteries(random);
    paintTree(painter, headSinuses(random), geometry, brainHu + sinusShare * (options.bloodHu - brainHu));
    paintTree(painter, scan.arteries, geometry, options.bloodHu);
    blurScan(grid, options.blurVoxels);
    scan.volume = storedVolume(grid, options.noiseHu, random.fork(1));
    for (const VesselBranch& branch : scan.arteries.branches) {
        if (branch.generation == 0) {   // above the base of the skull
            scan.origins.push_back(branch.pointsInPatient[branch.pointsInPatient.size() - 6]);
        }
    }
    return scan;
}

}   // namespace angiopose::core
