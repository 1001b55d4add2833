#include "core/simulation/paint_torso.h"
#include "tests/support/bodies/body_anatomy.h"
#include "tests/support/bodies/drawn_scan.h"
#include "tests/support/bodies/scan_artefacts.h"

namespace angiopose::core {
namespace {

constexpr double trunkBlurVoxels = 0.6;
constexpr double coarser = 1.7;   ///< voxel size relative to heads, for larger fields
constexpr double trunkMrNoisePerHu = 0.6;
constexpr double grayOfAir = 1024.0;
const TrunkValues mrTrunk{120.0, 100.0, 20.0, 90.0, 15.0, 180.0, 380.0, 160.0, 700.0, 1000.0};

ScanBox trunkBox(ScanKind kind, CounterRandom& random)
{
    switch (kind) {
        case ScanKind::BodyMra:
            return {{-130.0, -55.0, -225.0}, {130.0, 75.0, 130.0}};
        case ScanKind::LegMra:
            return {{-115.0, -50.0, -585.0}, {115.0, 65.0, -160.0}};
        case ScanKind::ThoraxCropped:   // the right face cuts the ascending aorta, or the left one the descending aorta
            return {{random.uniform(-30.0, -14.0), random.uniform(-60.0, -20.0), random.uniform(-40.0, -10.0)},
                    {random.uniform(16.0, 40.0), 62.0, random.uniform(70.0, 110.0)}};
        default:
            return {{-155.0, -100.0, -290.0}, {155.0, 108.0, -10.0}};
    }
}

AnyScan drawTrunkMr(const ScanDraw& draw, ScanGrid& grid, CounterRandom& random)
{
    ScanPainter painter(grid);
    AnyScan scan;
    scan.arteries = bodyArteries(random);
    scan.upstream = leftVentricle();
    paintBody(painter, mrTrunk, random);
    paintTree(painter, scan.arteries, grid.geometry, mrTrunk.artery);
    blurScan(grid, trunkBlurVoxels);
    const VolumeGeometry& geometry = grid.geometry;
    const double highMm = geometry.originInPatient.z() + geometry.spacingMm.z() * geometry.size.z();
    const double middleMm = 0.5 * (geometry.originInPatient.z() + highMm);
    applyFallOff(grid, {{0.0, -20.0, middleMm + random.uniform(-40.0, 40.0)}, draw.fallOff});
    scan.volume = asMagnitudes(grid, trunkMrNoisePerHu * draw.noise, random.fork(1));
    return scan;
}

AnyScan drawTrunkCt(ScanKind kind, const ScanDraw& draw, ScanGrid& grid, CounterRandom& random)
{
    ScanPainter painter(grid);
    AnyScan scan;
    scan.arteries = bodyArteries(random);
    scan.upstream = leftVentricle();
    TrunkValues values;
    values.artery = draw.bloodHu;
    values.rightHeart = random.uniform(0.5, 0.8) * draw.bloodHu;
    paintBody(painter, values, random);
    paintTree(painter, scan.arteries, grid.geometry, draw.bloodHu);
    blurScan(grid, trunkBlurVoxels);
    scan.volume = storedVolume(grid, draw.noise, random.fork(1));
    if (kind == ScanKind::AbdomenGray) {
        for (std::int16_t& voxel : scan.volume.voxels) {
            voxel = static_cast<std::int16_t>(std::max(0.0, voxel + grayOfAir));
        }
    }
    return scan;
}

}   // namespace

AnyScan drawTrunk(ScanKind kind, const ScanDraw& draw, CounterRandom& random)
{
    const double voxelMm = (kind == ScanKind::ThoraxCropped ? 1.0 : coarser) * draw.voxelMm;
    const double alongMm = kind == ScanKind::AbdomenThick ? draw.sliceMm : voxelMm;
    const bool isMr = kind == ScanKind::BodyMra || kind == ScanKind::LegMra;
    const ScanBox box = trunkBox(kind, random);
    ScanGrid grid(gridOf(box, {voxelMm, voxelMm, alongMm}), static_cast<float>(isMr ? 0.0 : airHu));
    return isMr ? drawTrunkMr(draw, grid, random) : drawTrunkCt(kind, draw, grid, random);
}

}   // namespace angiopose::core
