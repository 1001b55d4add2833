#include "core/simulation/paint_torso.h"
#include "core/simulation/smooth_path.h"
#include "tests/support/bodies/body_shapes.h"
#include "tests/support/bodies/drawn_scan.h"
#include "tests/support/bodies/head_anatomy.h"
#include "tests/support/bodies/scan_artefacts.h"

#include <numbers>

namespace angiopose::core {
namespace {

constexpr double blurVoxels = 0.7;
constexpr double halfFilled = 0.5;   ///< share of the arteries' contrast in the sinuses
constexpr double brightestMr = 1000.0;
constexpr double mrNoisePerHu = 0.8;
constexpr double finer = 0.7;   ///< voxel size relative to other heads, for rotational angiography
constexpr double neckEndMm = -110.0;
const HeadValues ctValues;
const HeadValues mrValues{420.0, 60.0, 150.0, 330.0, 50.0, 160.0};
const HeadValues rotationalValues{700.0, 1500.0, 1000.0, 700.0, 1600.0, 1300.0};   // values of a 12-bit detector

bool isMr(ScanKind kind)
{
    return kind == ScanKind::HeadTof || kind == ScanKind::HeadTofSlab;
}

bool isLate(ScanKind kind)
{
    return kind == ScanKind::HeadCtaLate || kind == ScanKind::HeadCtaMalformation ||
           kind == ScanKind::HeadCtaAboveBase || kind == ScanKind::HeadCtaThick;
}

ScanBox boxOf(ScanKind kind, CounterRandom& random)
{
    switch (kind) {
        case ScanKind::HeadCtaAboveBase:
            return {{-85.0, -92.0, random.uniform(-42.0, -34.0)}, {85.0, 108.0, 88.0}};
        case ScanKind::HeadTof:
            return {{-85.0, -92.0, -94.0}, {85.0, 108.0, 46.0}};
        case ScanKind::HeadTofSlab:
            return {{-85.0, -92.0, -62.0}, {85.0, 108.0, 12.0}};
        case ScanKind::HeadRotational:
            return {{-64.0, -72.0, -86.0}, {64.0, 56.0, 42.0}};
        default:
            return {{-85.0, -92.0, -94.0}, {85.0, 108.0, 88.0}};
    }
}

/// Makes the bone realistic: uneven, and spongy between its two tables.
void roughenBone(ScanPainter& painter, ScanGrid& grid, const HeadValues& values, CounterRandom random)
{
    const TurnedEllipsoid outer{{0.0, 8.0, 2.0}, Eigen::Matrix3d::Identity(), {74.0, 90.0, 78.0}};
    painter.forEachVoxelAround(
        outer.center, Eigen::Vector3d::Constant(120.0), [&](std::size_t voxel, const Eigen::Vector3d& place) {
            float& value = grid.voxels[voxel];
            const double overBrain = value - values.brain;
            if (overBrain / (values.skull - values.brain) < 0.5) {
                return;
            }
            const double belowMm = -outer.distanceMm(place);
            const bool isSpongy = belowMm > 1.6 && belowMm < 4.4;
            const double share = isSpongy ? 0.55 * (1.0 + 0.35 * random.normal()) : 1.0 + 0.15 * random.normal();
            value = static_cast<float>(values.brain + share * overBrain);
        });
}

/// Extends vessels that enter from the neck to below the range of any scan.
VesselTree fromBelow(VesselTree tree)
{
    for (VesselBranch& branch : tree.branches) {
        if (branch.pointsInPatient.front().z() < -80.0) {
            Eigen::Vector3d below = branch.pointsInPatient.front();
            below.z() = neckEndMm;
            branch.pointsInPatient.insert(branch.pointsInPatient.begin(), below);
            branch.radiusMm.insert(branch.radiusMm.begin(), branch.radiusMm.front());
        }
    }
    return tree;
}

/// One carotid artery and the branches it feeds.
VesselTree ofOneSide(const VesselTree& tree, double side)
{
    VesselTree chosen;
    for (const VesselBranch& branch : tree.branches) {
        double across = 0.0;
        double front = 0.0;
        for (const Eigen::Vector3d& point : branch.pointsInPatient) {
            across += side * point.x() / static_cast<double>(branch.pointsInPatient.size());
            front = std::max(front, point.y());
        }
        if (across > 1.0 && front < 40.0 && branch.pointsInPatient.front().y() < 10.0) {
            chosen.branches.push_back(branch);
        }
    }
    return chosen;
}

/// A point just inside the skull in the mid-sagittal plane, at an angle from the back over the vertex.
Eigen::Vector3d besideVault(double angle, double radiusMm)
{
    return {0.0, 8.0 + (83.5 - radiusMm) * std::cos(angle), 2.0 + (71.5 - radiusMm) * std::sin(angle)};
}

/// The sagittal, straight, transverse and sigmoid sinuses along the inner table, and the jugular veins.
VesselTree sinusesAlongSkull(CounterRandom& random)
{
    VesselTree tree;
    VesselBranch sagittal;
    constexpr int steps = 60;
    for (int n = 0; n <= steps; ++n) {
        const double share = static_cast<double>(n) / steps;
        const double radius = 1.8 + 2.7 * share;
        sagittal.pointsInPatient.push_back(besideVault(std::numbers::pi * (0.88 - 0.91 * share), radius));
        sagittal.radiusMm.push_back(radius);
    }
    const Eigen::Vector3d torcular = sagittal.pointsInPatient.back();
    addBranch(tree, std::move(sagittal), 0);
    addBranch(tree, taperedBranch({{0.0, 30.0, 6.0}, {0.0, 60.0, 2.0}, torcular}, 2.0, 2.4), 1);
    const double wide = random.uniform(-1.0, 1.0) < 0.0 ? -1.0 : 1.0;   // one side is dominant
    for (const double side : {-1.0, 1.0}) {
        std::vector<Eigen::Vector3d> way;
        for (int n = 0; n <= 20; ++n) {
            const double angle = 0.5 * std::numbers::pi - 0.055 * n;
            way.emplace_back(side * 63.0 * std::cos(angle), 8.0 + 79.0 * std::sin(angle), torcular.z() - 0.7 * n);
        }
        for (const Eigen::Vector3d& end :
             {Eigen::Vector3d(side * 26.0, 32.0, -60.0), Eigen::Vector3d(side * 30.0, 14.0, -80.0),
              Eigen::Vector3d(side * 32.0, 14.0, neckEndMm)}) {
            const Eigen::Vector3d from = way.back();
            for (int n = 1; n <= 10; ++n) {
                way.push_back(from + 0.1 * n * (end - from));
            }
        }
        const double radius = side == wide ? 4.2 : 3.0;
        addBranch(tree, taperedBranch(way, radius, 1.3 * radius), 1);
    }
    return tree;
}

/// Vessels from the end of a cerebral artery through a nidus into the sagittal sinus.
VesselTree malformation(const VesselTree& arteries, CounterRandom& random)
{
    VesselTree tree;
    const VesselBranch& feeder = arteries.branches[static_cast<std::size_t>(2 + random.index(2))];
    const Eigen::Vector3d nidus = feeder.pointsInPatient.back() + Eigen::Vector3d(6.0, 4.0, 10.0);
    addBranch(tree, taperedBranch({feeder.pointsInPatient.back(), nidus}, 1.2, 1.2), 0);
    for (int n = 0; n < 8; ++n) {
        const auto aside = [&] { return Eigen::Vector3d(random.normal(), random.normal(), random.normal()); };
        addBranch(tree, taperedBranch({nidus, nidus + 6.0 * aside(), nidus + 6.0 * aside(), nidus}, 0.9, 0.9), 1);
    }
    const Eigen::Vector3d drain = besideVault(1.5, 3.0);
    addBranch(tree,
              taperedBranch(smoothPath({nidus, drain, Eigen::Vector3d(0.3, 0.3, 0.9).normalized(),
                                        Eigen::Vector3d(0.8, 0.0, 0.3).normalized(), 1.0},
                                       random),
                            2.0, 2.4),
              1);
    return tree;
}

AnyScan drawCt(ScanKind kind, const ScanDraw& draw, ScanGrid& grid, CounterRandom& random)
{
    ScanPainter painter(grid);
    paintHead(painter, ctValues);
    roughenBone(painter, grid, ctValues, random.fork(2));
    AnyScan scan;
    scan.arteries = fromBelow(headArteries(random));
    const double share = isLate(kind) ? random.uniform(0.95, 1.08) : halfFilled;
    paintTree(painter, sinusesAlongSkull(random), grid.geometry,
              ctValues.brain + share * (draw.bloodHu - ctValues.brain));
    if (kind == ScanKind::HeadCtaMalformation) {
        paintTree(painter, malformation(scan.arteries, random), grid.geometry, draw.bloodHu);
    }
    paintTree(painter, scan.arteries, grid.geometry, draw.bloodHu);
    blurScan(grid, blurVoxels);
    scan.volume = storedVolume(grid, draw.noise, random.fork(1));
    return scan;
}

/// Blood excited repeatedly along its path is less bright, as are thin vessels, where it flows near the wall.
AnyScan drawTof(const ScanDraw& draw, ScanGrid& grid, CounterRandom& random)
{
    ScanPainter painter(grid);
    paintHead(painter, mrValues);
    AnyScan scan;
    scan.arteries = fromBelow(headArteries(random));
    const double lowMm = grid.geometry.originInPatient.z();
    const double saturation = random.uniform(0.2, 0.35);
    blendTree(painter, sinusesAlongSkull(random), [&](std::size_t) { return 1.1 * mrValues.brain; });
    blendTree(painter, scan.arteries, [&](std::size_t voxel) {
        const double upMm = grid.geometry.spacingMm.z() * grid.geometry.voxelAt(voxel).z();
        return brightestMr * (1.0 - saturation * std::min(1.0, upMm / (60.0 - 0.2 * lowMm)));
    });
    blurScan(grid, blurVoxels);
    applyFallOff(grid, {{0.0, 40.0, -10.0}, 1.0 + 0.4 * (draw.fallOff - 1.0)});
    scan.volume = asMagnitudes(grid, mrNoisePerHu * draw.noise, random.fork(1));
    return scan;
}

AnyScan drawRotational(const ScanDraw& draw, ScanGrid& grid, CounterRandom& random)
{
    ScanPainter painter(grid);
    paintHead(painter, rotationalValues);
    roughenBone(painter, grid, rotationalValues, random.fork(2));
    AnyScan scan;
    scan.arteries = ofOneSide(fromBelow(headArteries(random)), random.index(2) == 0 ? -1.0 : 1.0);
    paintTree(painter, scan.arteries, grid.geometry, random.uniform(3200.0, 3900.0));
    blurScan(grid, blurVoxels);
    addConeBeamArtefacts(grid, random.uniform(120.0, 220.0), random);
    scan.volume = asMagnitudes(grid, 3.0 * draw.noise, random.fork(1));
    return scan;
}

}   // namespace

AnyScan drawHead(ScanKind kind, const ScanDraw& draw, CounterRandom& random)
{
    const bool isThick = kind == ScanKind::HeadCtaThick;
    const double voxelMm = (kind == ScanKind::HeadRotational ? finer : 1.0) * draw.voxelMm;
    const double alongMm = isThick ? draw.sliceMm : voxelMm;
    ScanGrid grid(gridOf(boxOf(kind, random), {voxelMm, voxelMm, alongMm}),
                  static_cast<float>(isMr(kind) || kind == ScanKind::HeadRotational ? 0.0 : airHu));
    return isMr(kind)                         ? drawTof(draw, grid, random)
           : kind == ScanKind::HeadRotational ? drawRotational(draw, grid, random)
                                              : drawCt(kind, draw, grid, random);
}

}   // namespace angiopose::core
