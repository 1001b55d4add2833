#include "core/simulation/simulate_cta.h"

#include "core/simulation/paint_torso.h"
#include "core/simulation/scan_painter.h"
#include "core/simulation/stent_wires.h"
#include "core/vessel/polyline.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace angiopose::core {
namespace {

constexpr double tableHu = 150.0;
constexpr double calcificationHu = 950.0;
constexpr double metalHu = 8000.0;   ///< stent struts, before blurring
constexpr double treeFraction = 0.72;   ///< size of the tree as a fraction of the scan's shortest side

/// Paints liver, spleen and kidneys with some enhancement, and lungs at the top.
void paintOrgans(ScanPainter& painter, const ScanField& field, CounterRandom& random)
{
    const auto place = [&](double x, double y, double z) {
        return (field.center + field.half.cwiseProduct(Eigen::Vector3d(x, y, z)) +
                3.0 * Eigen::Vector3d(random.normal(), random.normal(), random.normal()))
            .eval();
    };
    painter.ellipsoid(place(-0.4, -0.1, 0.2), field.half.cwiseProduct(Eigen::Vector3d(0.4, 0.5, 0.5)), 105.0);
    painter.ellipsoid(place(0.55, 0.2, 0.3), field.half.cwiseProduct(Eigen::Vector3d(0.2, 0.3, 0.35)), 120.0);
    for (const double side : {-1.0, 1.0}) {
        painter.ellipsoid(place(0.5 * side, 0.35, -0.4), field.half.cwiseProduct(Eigen::Vector3d(0.15, 0.18, 0.3)),
                          150.0);
        painter.ellipsoid(place(0.5 * side, 0.0, 1.05), field.half.cwiseProduct(Eigen::Vector3d(0.3, 0.5, 0.3)),
                          lungHu);
    }
}

void paintTable(ScanPainter& painter, const ScanField& field)
{
    const double top = field.center.y() + 0.95 * field.half.y();
    painter.forEachVoxelAround(
        {field.center.x(), top + 2.0, field.center.z()}, {field.half.x(), 3.0, field.half.z()},
        [&](std::size_t voxel, const Eigen::Vector3d& point) {
            painter.blend(voxel, fractionInside(std::abs(point.y() - top - 2.0) - 1.5, painter.voxelMm()), tableHu);
        });
}

/// Paints calcified plaques that lie in the vessel wall and hardly extend into the lumen.
void paintCalcifications(ScanPainter& painter, const VesselTree& tree, int count, CounterRandom& random)
{
    for (int n = 0; n < count; ++n) {
        const VesselBranch& branch =
            tree.branches[static_cast<std::size_t>(random.index(static_cast<int>(tree.branches.size())))];
        const auto at = static_cast<std::size_t>(random.index(static_cast<int>(branch.pointsInPatient.size())));
        const Eigen::Vector3d aside = Eigen::Vector3d(random.normal(), random.normal(), random.normal()).normalized();
        const double size = random.uniform(0.5, 1.4);
        painter.ellipsoid(branch.pointsInPatient[at] + (branch.radiusMm[at] + 0.6 * size) * aside,
                          Eigen::Vector3d::Constant(size), calcificationHu);
    }
}

}   // namespace

TreeOptions treeOptionsForScan(const TreeOptions& tree, const CtaOptions& cta)
{
    TreeOptions fitting = tree;
    const ScanField field = fieldOf(gridAroundOrigin(cta.size, cta.spacingMm));
    fitting.extentMm = std::min(tree.extentMm, 2.0 * treeFraction * field.half.minCoeff());
    return fitting;
}

SimulatedCta simulateCta(std::uint64_t seed, const TreeOptions& tree, const CtaOptions& cta)
{
    CounterRandom random(seed ^ 0xC7A0ULL);
    const VolumeGeometry geometry = gridAroundOrigin(cta.size, cta.spacingMm);
    const ScanField field = fieldOf(geometry);

    SimulatedCta result;
    result.tree = simulateTree(seed, treeOptionsForScan(tree, cta));

    ScanGrid grid(geometry, static_cast<float>(airHu));
    ScanPainter painter(grid);
    paintTorso(painter, field);
    paintOrgans(painter, field, random);
    paintSkeleton(painter, field, random);
    paintTable(painter, field);
    paintTree(painter, result.tree, geometry, cta.bloodHu);
    if (cta.hasStent) {
        paintTree(painter, stentWires(result.tree.branches.front()), geometry, metalHu);
    }
    paintCalcifications(painter, result.tree, cta.calcificationCount, random);
    blurScan(grid, cta.blurVoxels);
    result.volume = storedVolume(grid, cta.noiseHu, random.fork(1));
    return result;
}

}   // namespace angiopose::core
