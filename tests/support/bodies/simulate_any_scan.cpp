#include "tests/support/bodies/simulate_any_scan.h"

#include "tests/support/bodies/body_shapes.h"
#include "tests/support/bodies/drawn_scan.h"

#include <array>

namespace angiopose::core {
namespace {

constexpr double axisStepMm = 1.0;

constexpr std::array<NamedScanKind, 13> kinds{{
    {"head-cta", ScanKind::HeadCta},
    {"head-cta-late", ScanKind::HeadCtaLate},
    {"head-cta-malformation", ScanKind::HeadCtaMalformation},
    {"head-cta-above-base", ScanKind::HeadCtaAboveBase},
    {"head-cta-thick", ScanKind::HeadCtaThick},
    {"head-tof", ScanKind::HeadTof},
    {"head-tof-slab", ScanKind::HeadTofSlab},
    {"body-mra", ScanKind::BodyMra},
    {"leg-mra", ScanKind::LegMra},
    {"head-rotational", ScanKind::HeadRotational},
    {"abdomen-thick", ScanKind::AbdomenThick},
    {"abdomen-grey", ScanKind::AbdomenGray},
    {"thorax-cropped", ScanKind::ThoraxCropped},
}};

bool isTrunk(ScanKind kind)
{
    return kind == ScanKind::BodyMra || kind == ScanKind::LegMra || kind == ScanKind::AbdomenThick ||
           kind == ScanKind::AbdomenGray || kind == ScanKind::ThoraxCropped;
}

/// Keeps the sections of branches whose axes lie inside the scan.
VesselTree within(const VolumeGeometry& grid, const VesselTree& tree)
{
    const Eigen::Affine3d voxelFromPatient = grid.patientFromVoxel().inverse();
    VesselTree parts;
    for (const VesselBranch& branch : tree.branches) {
        VesselBranch part;
        const auto finish = [&] {
            if (part.pointsInPatient.size() > 1) {
                addBranch(parts, std::move(part), branch.generation);
            }
            part = {};
        };
        for (std::size_t n = 0; n < branch.pointsInPatient.size(); ++n) {
            const Eigen::Vector3i at = (voxelFromPatient * branch.pointsInPatient[n]).array().round().cast<int>();
            if (!grid.contains(at)) {
                finish();
                continue;
            }
            part.pointsInPatient.push_back(branch.pointsInPatient[n]);
            part.radiusMm.push_back(branch.radiusMm[n]);
        }
        finish();
    }
    return parts;
}

/// Turns the scan into that of another patient: larger or smaller, and with the sides exchanged.
void alterPatient(AnyScan& scan, const ScanDraw& draw)
{
    const Eigen::Vector3d factor(draw.isMirrored ? -draw.scale : draw.scale, draw.scale, draw.scale);
    VolumeGeometry& grid = scan.volume.geometry;
    grid.spacingMm *= draw.scale;
    grid.originInPatient = factor.cwiseProduct(grid.originInPatient);
    grid.direction.col(0).x() = draw.isMirrored ? -1.0 : 1.0;
    for (VesselTree* tree : {&scan.arteries, &scan.upstream}) {
        for (VesselBranch& branch : tree->branches) {
            for (std::size_t n = 0; n < branch.pointsInPatient.size(); ++n) {
                branch.pointsInPatient[n] = factor.cwiseProduct(branch.pointsInPatient[n]);
                branch.radiusMm[n] *= draw.scale;
            }
        }
    }
}

}   // namespace

std::span<const NamedScanKind> allScanKinds()
{
    return kinds;
}

ScanDraw drawScan(ScanRanges ranges, CounterRandom& random)
{
    const bool isJudging = ranges == ScanRanges::Judging;
    ScanDraw draw;
    draw.voxelMm = isJudging ? random.uniform(0.55, 0.8) : 0.7;
    draw.sliceMm = random.uniform(3.0, 5.0);
    draw.bloodHu = isJudging ? random.uniform(300.0, 480.0) : random.uniform(380.0, 420.0);
    draw.noise = isJudging ? random.uniform(15.0, 35.0) : 25.0;
    draw.fallOff = isJudging ? random.uniform(3.0, 5.0) : random.uniform(3.0, 4.0);
    draw.scale = isJudging ? random.uniform(0.9, 1.1) : 1.0;
    draw.isMirrored = isJudging && random.index(2) == 1;
    return draw;
}

VolumeGeometry gridOf(const ScanBox& box, const Eigen::Vector3d& spacingMm)
{
    VolumeGeometry grid;
    grid.size = ((box.high - box.low).cwiseQuotient(spacingMm)).array().round().cast<int>();
    grid.spacingMm = spacingMm;
    grid.originInPatient = box.low + 0.5 * spacingMm;
    return grid;
}

AnyScan simulateAnyScan(ScanKind kind, std::uint64_t seed, ScanRanges ranges)
{
    CounterRandom random(seed ^ (ranges == ScanRanges::Judging ? 0xA175CA9ULL : 0x5CA9ULL));
    const ScanDraw draw = drawScan(ranges, random);
    AnyScan scan = isTrunk(kind) ? drawTrunk(kind, draw, random) : drawHead(kind, draw, random);
    const bool beginsBelow = isTrunk(kind) || kind == ScanKind::HeadRotational;
    for (const VesselBranch& branch : scan.arteries.branches) {
        if (branch.generation <= (beginsBelow ? 1 : 0)) {
            scan.great.push_back(branch.id);
        }
    }
    scan.arteries = resampled(scan.arteries, axisStepMm);
    scan.upstream = resampled(scan.upstream, axisStepMm);
    alterPatient(scan, draw);
    scan.seen = within(scan.volume.geometry, scan.arteries);
    return scan;
}

}   // namespace angiopose::core
