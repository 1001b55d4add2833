#include "tests/support/bodies/body_anatomy.h"

#include "core/simulation/smooth_path.h"
#include "tests/support/bodies/body_shapes.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace angiopose::core {
namespace {

constexpr double endless = std::numeric_limits<double>::infinity();
constexpr double vertebraMm = 30.0;

const Eigen::Vector3d up(0.0, 0.0, 1.0);
const Eigen::Vector3d root(2.0, -8.0, 22.0);
const Eigen::Vector3d arch(4.0, 6.0, 82.0);
const Eigen::Vector3d fork(2.0, 24.0, -190.0);

void addVessel(VesselTree& tree, const PathPlan& plan, double firstMm, double lastMm, int generation,
               CounterRandom& random)
{
    addBranch(tree, taperedBranch(smoothPath(plan, random), firstMm, lastMm), generation);
}

void addAorta(VesselTree& tree, CounterRandom& random)
{
    const Eigen::Vector3d below(19.0, 29.0, 50.0);
    const Eigen::Vector3d across = Eigen::Vector3d(0.45, 0.85, 0.1).normalized();
    std::vector<Eigen::Vector3d> way = smoothPath({root, arch, Eigen::Vector3d(-0.5, -0.1, 0.85), across, 0.1}, random);
    for (const PathPlan& plan : {PathPlan{arch, below, across, -up, 0.1}, PathPlan{below, fork, -up, -up, 0.5}}) {
        const auto more = smoothPath(plan, random);
        way.insert(way.end(), more.begin() + 1, more.end());
    }
    addBranch(tree, taperedBranch(way, 14.0, 8.0), 0);
}

void addBranchesOfArch(VesselTree& tree, CounterRandom& random)
{
    addVessel(tree, {{0.0, -4.0, 80.0}, {-22.0, -6.0, 160.0}, up, up, 0.6}, 5.5, 4.5, 2, random);
    addVessel(tree, {{5.0, 6.0, 82.0}, {22.0, 0.0, 160.0}, up, up, 0.6}, 3.5, 3.2, 2, random);
    addVessel(tree, {{11.0, 14.0, 80.0}, {55.0, 18.0, 150.0}, up, Eigen::Vector3d(1.0, 0.0, 0.2).normalized(), 0.6},
              4.5, 3.8, 2, random);
}

void addBranchesOfBelly(VesselTree& tree, CounterRandom& random)
{
    const VesselBranch aorta = tree.branches.front();
    const auto atHeight = [&](double z) {
        return *std::min_element(
            aorta.pointsInPatient.rbegin(), aorta.pointsInPatient.rbegin() + 200,
            [&](const auto& a, const auto& b) { return std::abs(a.z() - z) < std::abs(b.z() - z); });
    };
    const Eigen::Vector3d forward = Eigen::Vector3d(0.0, -1.0, -0.3).normalized();
    addVessel(tree,
              {atHeight(-75.0), {-38.0, -12.0, -72.0}, forward, Eigen::Vector3d(-1.0, 0.0, 0.2).normalized(), 0.8}, 3.4,
              2.4, 2, random);
    addVessel(tree, {atHeight(-88.0), {-8.0, -22.0, -180.0}, forward, -up, 0.8}, 3.6, 2.2, 2, random);
    for (const double side : {-1.0, 1.0}) {
        const Eigen::Vector3d outward(side, 0.0, 0.0);
        addVessel(tree, {atHeight(-100.0), {side * 50.0, 36.0, -108.0}, outward, outward, 0.5}, 2.8, 2.3, 2, random);
    }
}

void addLegs(VesselTree& tree, CounterRandom& random)
{
    for (const double side : {-1.0, 1.0}) {
        const Eigen::Vector3d down = Eigen::Vector3d(side * 0.4, 0.1, -0.9).normalized();
        const Eigen::Vector3d groin(side * 62.0, -18.0, -330.0);
        const Eigen::Vector3d knee(side * 52.0, 24.0, -600.0);
        const Eigen::Vector3d end = tree.branches.front().pointsInPatient.back();
        addVessel(tree, {end, groin, down, -up, 0.7}, 5.5, 4.2, 1, random);
        addVessel(tree, {groin, knee, -up, -up, 0.4}, 3.8, 2.8, 1, random);
        addVessel(tree,
                  {groin, {side * 78.0, 18.0, -500.0}, Eigen::Vector3d(side * 0.4, 0.6, -0.7).normalized(), -up, 0.6},
                  3.0, 1.6, 2, random);
    }
}

VesselTree bodyVeins(CounterRandom& random)
{
    VesselTree veins;
    addVessel(veins, {{-20.0, 6.0, 0.0}, {-21.0, 28.0, -190.0}, -up, -up, 0.3}, 10.0, 9.0, 0, random);
    addVessel(veins, {{-34.0, -8.0, 26.0}, {-36.0, -4.0, 160.0}, up, up, 0.2}, 9.0, 8.0, 0, random);
    for (const double side : {-1.0, 1.0}) {
        const Eigen::Vector3d groin(side * 55.0, -12.0, -330.0);
        addVessel(veins, {{-20.0, 30.0, -190.0}, groin, -up, -up, 0.5}, 7.0, 5.0, 1, random);
        addVessel(veins, {groin, {side * 46.0, 34.0, -600.0}, -up, -up, 0.4}, 5.0, 4.0, 1, random);
    }
    return veins;
}

/// The chambers of the left heart contain the same blood as the arteries.
void paintHeart(ScanPainter& painter, const TrunkValues& values, CounterRandom& random)
{
    painter.ellipsoid({12.0, -28.0, 0.0}, {52.0, 38.0, 42.0}, values.muscle);
    painter.ellipsoid({-4.0, 17.0, 12.0}, {13.0, 6.0, 12.0}, values.artery);
    painter.ellipsoid({-14.0, -50.0, -4.0}, {20.0, 12.0, 24.0}, values.rightHeart);
    painter.ellipsoid({-30.0, -20.0, 6.0}, {13.0, 17.0, 20.0}, values.rightHeart);
    VesselTree pulmonary;
    addVessel(pulmonary,
              {{2.0, -46.0, 18.0}, {26.0, -16.0, 56.0}, up, Eigen::Vector3d(0.4, 0.8, 0.4).normalized(), 0.1}, 11.0,
              9.0, 0, random);
    paintTree(painter, pulmonary, painter.geometry(), values.rightHeart);
    paintTree(painter, leftVentricle(), painter.geometry(), values.artery);
}

}   // namespace

VesselTree bodyArteries(CounterRandom& random)
{
    VesselTree tree;
    addAorta(tree, random);
    addBranchesOfArch(tree, random);
    addBranchesOfBelly(tree, random);
    addLegs(tree, random);
    return tree;
}

VesselTree leftVentricle()
{
    VesselBranch branch;
    branch.pointsInPatient = {{28.0, -32.0, -26.0}, {27.0, -31.0, -16.0}, {25.0, -29.0, -4.0},
                              {18.0, -22.0, 10.0},  {8.0, -14.0, 18.0},   root};
    branch.radiusMm = {8.0, 15.0, 17.0, 13.0, 12.0, 13.0};
    VesselTree tree;
    addBranch(tree, std::move(branch), 0);
    return tree;
}

void paintBody(ScanPainter& painter, const TrunkValues& values, CounterRandom& random)
{
    painter.ellipsoid({0.0, 5.0, 0.0}, {150.0, 98.0, endless}, values.fat);
    painter.ellipsoid({0.0, 5.0, 0.0}, {136.0, 84.0, endless}, values.muscle);
    for (const double side : {-1.0, 1.0}) {
        painter.ellipsoid({side * 78.0, 8.0, 40.0}, {46.0, 62.0, 90.0}, values.lung);
    }
    for (double z = -700.0; z < 220.0; z += vertebraMm) {
        if (z > -240.0) {
            painter.ellipsoid({0.0, 62.0, z}, {18.0, 15.0, 16.0}, values.cortex);
            painter.ellipsoid({0.0, 62.0, z}, {16.4, 13.4, 14.4}, values.marrow);
            continue;
        }
        for (const double side : {-1.0, 1.0}) {   // femurs
            painter.ellipsoid({side * 85.0, 10.0, z}, {13.0, 13.0, 20.0}, values.cortex);
            painter.ellipsoid({side * 85.0, 10.0, z}, {7.0, 7.0, 16.0}, values.marrow);
        }
    }
    painter.ellipsoid({-62.0, -6.0, -88.0}, {58.0, 62.0, 58.0}, values.liver);
    for (const double side : {-1.0, 1.0}) {
        painter.ellipsoid({side * 62.0, 40.0, -108.0}, {22.0, 20.0, 42.0}, values.kidney);
    }
    paintHeart(painter, values, random);
    paintTree(painter, bodyVeins(random), painter.geometry(), values.vein);
}

}   // namespace angiopose::core
