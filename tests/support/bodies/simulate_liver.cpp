#include "core/simulation/grow_tree.h"
#include "core/simulation/paint_torso.h"
#include "core/simulation/smooth_path.h"
#include "tests/support/bodies/body_shapes.h"
#include "tests/support/bodies/simulate_body.h"

#include <algorithm>

namespace angiopose::core {
namespace {

constexpr double liverHu = 95.0;
constexpr double portalShare = 0.45;   // share of the arteries' contrast: a late arterial phase
constexpr double portalWidth = 2.6;   // relative to the artery next to it
constexpr double betweenMm = 0.8;   // distance between the walls of artery and portal vein

/// The arteries within the liver, originating at the hilum.
VesselTree arteriesFrom(const Eigen::Vector3d& hilum, std::uint64_t seed, CounterRandom& random)
{
    TreeOptions options;
    options.branchCount = 8;
    options.extentMm = random.uniform(70.0, 85.0);
    options.rootRadiusMm = 2.2;
    VesselTree tree = growTree(seed, options).tree;
    const Eigen::Vector3d first = tree.branches.front().pointsInPatient.front();
    const Eigen::Vector3d towards = (centroidInPatient(tree) - first).normalized();
    // The liver is to the right of its hilum, whatever the direction in which the tree grew.
    const Eigen::Quaterniond turn =
        Eigen::Quaterniond::FromTwoVectors(towards, Eigen::Vector3d(-0.9, -0.1, 0.35).normalized());
    for (VesselBranch& branch : tree.branches) {
        for (Eigen::Vector3d& point : branch.pointsInPatient) {
            point = hilum + turn * (point - first);
        }
        for (double& radius : branch.radiusMm) {
            radius = std::max(radius, 0.8);
        }
    }
    return tree;
}

/// Branches of the portal vein, each along an artery.
VesselTree portalBeside(const VesselTree& arteries, CounterRandom& random)
{
    VesselTree portal;
    for (const VesselBranch& artery : arteries.branches) {
        const Eigen::Vector3d aside = Eigen::Vector3d(random.normal(), random.normal(), random.normal()).normalized();
        VesselBranch vein = artery;
        const std::vector<Eigen::Vector3d> tangents = tangentsOf(artery.pointsInPatient);
        for (std::size_t n = 0; n < vein.pointsInPatient.size(); ++n) {
            const Eigen::Vector3d across = aside - aside.dot(tangents[n]) * tangents[n];
            const double awayMm = (1.0 + portalWidth) * artery.radiusMm[n] + betweenMm;
            vein.pointsInPatient[n] += awayMm * across.normalized();
            vein.radiusMm[n] = portalWidth * artery.radiusMm[n];
        }
        addBranch(portal, std::move(vein), artery.generation);
    }
    return portal;
}

void paintUpperOrgans(ScanPainter& painter, double bloodHu)
{
    paintEllipsoid(painter, {{-42.0, -12.0, 12.0}, Eigen::Matrix3d::Identity(), {62.0, 52.0, 62.0}}, liverHu);
    paintEllipsoid(painter, {{68.0, 20.0, 20.0}, Eigen::Matrix3d::Identity(), {22.0, 32.0, 40.0}}, 125.0);   // spleen
    for (const double side : {-1.0, 1.0}) {
        paintEllipsoid(painter, {{side * 52.0, 38.0, -42.0}, Eigen::Matrix3d::Identity(), {20.0, 22.0, 34.0}},
                       0.5 * bloodHu);   // kidneys
    }
}

}   // namespace

BodyScan simulateLiver(std::uint64_t seed, const BodyScanOptions& options)
{
    CounterRandom random(seed ^ 0x11FE4ULL);
    const Eigen::Vector3d extentMm(260.0, 200.0, 150.0);
    const Eigen::Vector3d spacingMm = options.spacingMm * 1.3;   // a larger field with the same number of voxels
    const VolumeGeometry geometry =
        gridAroundOrigin(extentMm.cwiseQuotient(spacingMm).array().ceil().cast<int>(), spacingMm);
    const ScanField field = fieldOf(geometry);
    ScanGrid grid(geometry, static_cast<float>(airHu));
    ScanPainter painter(grid);
    paintTorso(painter, field);
    paintUpperOrgans(painter, options.bloodHu);
    paintSkeleton(painter, field, random);

    const Eigen::Vector3d coeliac(2.0, 22.0, 0.0);   // anterior to the aorta
    const Eigen::Vector3d fork(4.0, 4.0, 4.0);
    const Eigen::Vector3d hilum(-22.0, -4.0, 2.0);
    const Eigen::Vector3d forward(0.0, -1.0, 0.0);
    const Eigen::Vector3d rightward(-1.0, 0.0, 0.0);
    BodyScan scan;
    addBranch(scan.arteries, taperedBranch(smoothPath({coeliac, fork, forward, forward, 0.2}, random), 3.4, 3.0), 0);
    addBranch(scan.arteries, taperedBranch(smoothPath({fork, hilum, rightward, rightward, 0.8}, random), 2.5, 2.2), 1);
    const VesselTree inLiver = arteriesFrom(hilum, seed, random);
    for (const VesselBranch& branch : inLiver.branches) {
        addBranch(scan.arteries, branch, branch.generation + 2);
    }
    VesselTree aorta;
    addBranch(aorta, taperedBranch({{4.0, 32.0, -90.0}, {3.0, 32.0, 0.0}, {4.0, 34.0, 90.0}}, 10.0, 11.0), 0);
    VesselTree veins = portalBeside(inLiver, random);
    addBranch(
        veins,
        taperedBranch(
            smoothPath(
                {{14.0, 12.0, -60.0}, hilum + Eigen::Vector3d(2.0, 7.0, -2.0), {0.0, 0.0, 1.0}, {-0.8, -0.2, 0.5}, 0.2},
                random),
            7.0, 6.5),
        0);
    const double portalHu = liverHu + portalShare * (options.bloodHu - liverHu);
    paintTree(painter, veins, geometry, portalHu);
    paintTree(painter, aorta, geometry, options.bloodHu);
    paintTree(painter, scan.arteries, geometry, options.bloodHu);
    blurScan(grid, options.blurVoxels);
    scan.volume = storedVolume(grid, options.noiseHu, random.fork(1));
    const auto& main = scan.arteries.branches[1].pointsInPatient;
    scan.origins = {main[main.size() / 3]};
    return scan;
}

}   // namespace angiopose::core
